// SLIC superpixels (Achanta et al., PAMI 2012).
#ifndef STEREO_SGMP_PRIOR_SUPERPIXELS_H_
#define STEREO_SGMP_PRIOR_SUPERPIXELS_H_

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "common/thread_pool.h"
#include "prior/superpixel_kernel.h"

namespace stereo_sgmp {

// Clusters of pixels that are alike in colour and near each other, each connected (4-neighbours).
// Keeps its buffers from image to image. The same labels for any number of threads.
class Superpixels {
 public:
  // `image` is CV_8U with 1 (gray), 3 (BGR) or 4 (BGRA) channels, `size` >= 1 is the distance of
  // the initial centres in pixels. `compactness` > 0 weighs distance against colour: a colour
  // difference of that much (8-bit CIELAB) counts like a distance of `size`. `threads` may be
  // null. Throws std::invalid_argument otherwise.
  void Segment(const cv::Mat& image, int size, double compactness, ThreadPool* threads);

  // CV_32S, 0 ... count() - 1, of the size of the image; numbered in order of their first pixel.
  const cv::Mat& labels() const { return labels_; }
  int count() const { return count_; }

 private:
  // Sums over the pixels of a cluster. Whole numbers, so any order of adding gives the same.
  struct Sums {
    std::int64_t channel[3];
    std::int64_t x;
    std::int64_t y;
    std::int64_t pixels;
  };
  void Convert(const cv::Mat& image);
  void PlaceCentres(int size);
  void AssignRows(int begin, int end, int size, float spatial_weight);
  ClusterWindow WindowOf(const cv::Rect& box);
  void AddUp(int begin, int end, std::vector<Sums>* sums) const;
  void MoveCentres();
  void Connect(int smallest);
  int Flood(int start, int label);

  cv::Mat converted_;              // CV_8U, 1 or 3 channels
  std::vector<cv::Mat> bytes_;     // its channels
  std::vector<cv::Mat> channels_;  // the same as CV_32F, for the kernel
  std::vector<ClusterCentre> centres_;
  cv::Mat distance_;                     // CV_32F, to the nearest centre so far
  cv::Mat clusters_;                     // CV_32S, that centre; not yet connected
  std::vector<std::vector<Sums>> sums_;  // per thread
  cv::Mat labels_;
  std::vector<int> component_;  // pixels that are flooded
  int count_ = 0;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_SUPERPIXELS_H_
