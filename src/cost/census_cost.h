#ifndef STEREO_SGMP_COST_CENSUS_COST_H_
#define STEREO_SGMP_COST_CENSUS_COST_H_

#include <cstddef>
#include <cstdint>

#include <opencv2/core.hpp>

#include "common/thread_pool.h"
#include "cost/census_transform.h"
#include "cost/cost_rows.h"
#include "cost/feature_planes.h"
#include "cost/padded_gray.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// Hamming distance of census transforms, scaled to the range of the other costs: 4 a bit for 9x7
// (at most 248), 10 a bit for 5x5 (at most 240). Matches outside the right image cost half of
// the maximum. Compact costs are the CompactCost of these. Computed when asked for.
class CensusCost final : public CostRows {
 public:
  // Throws std::invalid_argument for a unit out of range.
  void Start(const VolumeShape& shape, CensusWindow window, int unit);
  // Then both, in any order or at once, before costs are asked for. Images: CV_8UC1 of the size of
  // the shape.
  void PrepareLeft(const cv::Mat& left, ThreadPool* pool);
  void PrepareRight(const cv::Mat& right, ThreadPool* pool);

  const VolumeShape& shape() const override { return shape_; }
  int unit() const override { return unit_; }
  const std::uint8_t* Row(int y, int x_begin, int x_end, std::uint8_t* scratch) const override;

  static std::size_t Memory(const VolumeShape& shape, CensusWindow window);

 private:
  void Transform(const PaddedGray& image, FeaturePlanes* planes, ThreadPool* pool) const;

  VolumeShape shape_;
  int unit_ = 1;
  CensusWindow window_ = CensusWindow::k9x7;
  PaddedGray left_image_;
  PaddedGray right_image_;
  FeaturePlanes left_;
  FeaturePlanes right_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_CENSUS_COST_H_
