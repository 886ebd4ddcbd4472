// Disparity planes found in a coarse disparity map (Sec. 5 of the paper, "E" variants).
#ifndef STEREO_SGMP_PRIOR_PLANE_HYPOTHESES_H_
#define STEREO_SGMP_PRIOR_PLANE_HYPOTHESES_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "common/aligned_buffer.h"
#include "common/thread_pool.h"
#include "prior/plane_fit.h"
#include "prior/region_growth_kernel.h"
#include "stereo_sgmp/disparity_plane.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

struct CoarseDisparity {
  const cv::Mat& disparity;  // CV_32F, coarse pixels, with sub-pixel
  const cv::Mat& confident;  // CV_8U, non-zero where the disparity may be used
};

struct CoarsePlane {
  DisparityPlane plane;  // coarse pixels
  int area = 0;          // pixels that carry the label
  double rms = 0.0;      // their root mean square distance, coarse pixels
};

struct PlaneMap {
  std::vector<CoarsePlane> planes;  // in falling order of area
  cv::Mat labels;                   // CV_16S, index into `planes`, -1 for none
};

// Pixels that a plane must have in a coarse image of `size`: PriorOptions::min_plane_area, or a
// fiftieth of a small image.
int SmallestPlane(const PriorOptions& options, cv::Size size);

// Region growing in disparity space, where the noise is even and planes of the scene are planes:
// windows that fit a plane best grow first, and take every confident pixel near their plane that
// can be reached over small gaps. Keeps its buffers from frame to frame; deterministic for any
// number of threads.
class PlaneHypotheses {
 public:
  // Finds the planes with at least `min_area` pixels. `threads` may be null.
  // Throws std::invalid_argument where the maps differ in size or have other types.
  void Find(const CoarseDisparity& coarse, int min_area, ThreadPool* threads);

  const PlaneMap& map() const { return map_; }

 private:
  struct Seed {
    double rank = 0.0;  // low = good: residual of the window, more for missing pixels
    int x = 0;
    int y = 0;
    DisparityPlane plane;
  };

  void Load(const CoarseDisparity& coarse);
  void FindSeeds(ThreadPool* threads);
  void FindSeedsOfRow(int row);
  void GrowFromSeeds(int min_area);
  void Grow(const Seed& seed);
  const PlaneMoments& Moments();
  // Makes the region a plane, if it is one; pixels far from the final plane are given back.
  bool Keep(int min_area);
  void Release(const DisparitySample* first);
  void SortByArea();

  int Index(int x, int y) const;

  // Padded, so that windows and gaps need no test for the border. Not a number where there is no
  // confident disparity, or a region has taken it.
  std::vector<float> disparity_;
  // Padded: whether a region has ever reached the pixel; such pixels don't seed another.
  std::vector<std::uint8_t> reached_;
  int stride_ = 0;
  std::vector<std::vector<Seed>> seeds_of_row_;
  std::vector<Seed> seeds_;

  Region region_;                          // that grows
  AlignedBuffer<DisparitySample> pixels_;  // its
  PlaneMoments moments_;                   // of its first pixels,
  std::size_t summed_ = 0;                 // so many

  std::vector<std::int16_t> order_;
  std::vector<std::int16_t> new_label_;
  std::vector<CoarsePlane> sorted_;
  PlaneMap map_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_PLANE_HYPOTHESES_H_
