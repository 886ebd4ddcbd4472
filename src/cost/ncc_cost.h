#ifndef STEREO_SGMP_COST_NCC_COST_H_
#define STEREO_SGMP_COST_NCC_COST_H_

#include <cstddef>
#include <cstdint>
#include <functional>

#include <opencv2/core.hpp>

#include "common/thread_pool.h"
#include "cost/cost_rows.h"
#include "cost/cost_volume.h"
#include "cost/padded_gray.h"
#include "cost/patch_statistics.h"

namespace stereo_sgmp {

// Truncated normalised cross correlation (the paper's C_p(d)):
//   C = round(255 (1 - max(0, NCC))),
//   NCC = sum (l - mean l)(r - mean r) / (sqrt(sum (l - mean l)^2 sum (r - mean r)^2) + epsilon)
// over 5x5 patches of gray levels 0..255. With vertical tolerance C is the minimum over the right
// rows y - 1, y and y + 1 inside the image. Matches outside the right image cost 255. Compact costs
// are the CompactCost of these.
// Sums are exact and the few float operations have one order: the same bits on every machine.
class NccCost final : public CostRows {
 public:
  // epsilon >= 0. Throws std::invalid_argument for a unit out of range.
  void Start(const VolumeShape& shape, double epsilon, bool vertical_tolerance, int unit);
  // Then both, in any order or at once, before costs are made. Images: CV_8UC1 of the size of the
  // shape.
  void PrepareLeft(const cv::Mat& left, ThreadPool* pool);
  void PrepareRight(const cv::Mat& right, ThreadPool* pool);

  // Make the costs, as StoredCost has it.
  void ComputeAhead(const std::function<bool()>& is_enough) { volume_.ComputeAhead(is_enough); }
  void Complete(ThreadPool* pool) { volume_.Complete(pool); }

  const VolumeShape& shape() const override { return volume_.shape(); }
  int unit() const override { return unit_; }
  const std::uint8_t* Row(int y, int x_begin, int x_end, std::uint8_t* scratch) const override {
    return volume_.Row(y, x_begin, x_end, scratch);
  }

  static std::size_t Memory(const VolumeShape& shape);

 private:
  int unit_ = 1;
  PaddedGray left_image_;
  PaddedGray right_image_;
  PatchStatistics left_;
  PatchStatistics right_;
  StoredCost volume_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_NCC_COST_H_
