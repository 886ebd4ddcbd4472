#ifndef STEREO_SGMP_REFINEMENT_PLANE_PROPAGATION_H_
#define STEREO_SGMP_REFINEMENT_PLANE_PROPAGATION_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "aggregation/contrast.h"
#include "common/aligned_buffer.h"
#include "common/thread_pool.h"
#include "refinement/plane_propagation_kernel.h"

namespace stereo_sgmp {

// A row of the buffers of PlanePropagation.
struct PropagationRow {
  const float* disparity = nullptr;
  const float* weight = nullptr;
  const std::uint8_t* difference = nullptr;  // of the colours of each pixel and the one before
  std::array<float*, PropagationStrip::kSums> sums = {};
};

// Moves unsure disparities onto the plane of the surer ones on the same surface, from as far as
// the surface goes on: a least-squares plane at each pixel p over all others q, weighted by
//   (confidence(q)^8 + 1e-6) times the product of the links between q and p.
// q links to p along its row to the column of p, and then along that column. The link of two
// neighbours is exp(-(3 + D) / 40) min(1, max(0, 1.5 - 2.5 |d - d'|)), D being the largest
// channel difference of the image and d, d' their disparities: no way leads across a step of
// 0.6 pixels. A ridge of 0.1 px^2 keeps the slopes steady.
//
// A pixel moves towards its plane, by two pixels at most, all the way where its confidence is
// below 0.8, and less and less up to 0.9, from where on it stays. All this happens twice.
// As recursive filters of the moments the time does not depend on the reach (after Gastal and
// Oliveira, Domain Transform for Edge-Aware Image and Video Processing, SIGGRAPH 2011).
// Keeps its buffers from call to call.
class PlanePropagation {
 public:
  PlanePropagation();

  // `image`: CV_8UC1 or CV_8UC3. `confidence`: CV_32F, 0 .. 1. `disparity`: CV_32F, finite; all
  // of one size. Results do not depend on the SIMD target or the number of threads.
  void Apply(const cv::Mat& image, const cv::Mat& confidence, cv::Mat* disparity, ThreadPool* pool);

  // Bytes per pixel that are kept.
  static constexpr std::size_t kBytesPerPixel =
      (PropagationStrip::kSums + 4) * sizeof(float) + kPathsPerSweep * sizeof(std::uint8_t);

 private:
  static constexpr int kDifferences = 256;

  void Reserve(cv::Size size, int threads);
  void LoadRow(const cv::Mat& confidence, const cv::Mat& disparity, int y);
  void LinkDown(int width, int y);
  void SumAlongRows(int width, int begin, int end);
  PropagationRow RowAt(int y);
  void MoveToPlanes(int strip, int height, float* scratch);
  std::ptrdiff_t Offset(int y) const { return y * stride_; }

  std::array<float, kDifferences> color_link_;
  Contrast contrast_;
  std::ptrdiff_t stride_ = 0;  // of all buffers below: whole strips
  AlignedBuffer<float> disparity_;
  AlignedBuffer<float> weight_;
  AlignedBuffer<float> share_;  // of the way to the plane
  AlignedBuffer<float> down_;   // link to the pixel above
  std::array<AlignedBuffer<float>, PropagationStrip::kSums> sums_;
  std::vector<AlignedBuffer<float>> scratch_;  // per thread
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_PLANE_PROPAGATION_H_
