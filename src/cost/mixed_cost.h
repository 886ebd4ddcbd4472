#ifndef STEREO_SGMP_COST_MIXED_COST_H_
#define STEREO_SGMP_COST_MIXED_COST_H_

#include <cstddef>
#include <cstdint>

#include <opencv2/core.hpp>

#include "common/thread_pool.h"
#include "cost/cost_rows.h"
#include "cost/feature_planes.h"
#include "cost/padded_gray.h"
#include "cost/radiometric_fit.h"

namespace stereo_sgmp {

// Census, absolute difference and gradient in one cost, full (unit 1) or compact (unit 7):
//   C(d) = min(255, 7 h + floor(h / 4) + ad + 10 g),
//   C(d) = min(36, h + g + ceil((ad + 3 g) / 8)).
// h: Hamming distance of 7x5 census transforms, which bear any change of exposure.
// ad = w min(30, |I_l - I_r'|) with I_r' = gain I_r + offset and w = ad_weight, the radiometric
// fit. g = min(10, |dx I_l - dx I_r| + |dy I_l - dy I_r|), where dx I = I(x + 1, y) - I(x - 1, y),
// likewise dy, saturated to -128..127.
// Matches outside the right image cost what half of each of h, ad and g does. Computed when asked
// for.
class MixedCost final : public CostRows {
 public:
  // Of the compact costs.
  static constexpr int kCompactUnit = 7;

  // Throws std::invalid_argument unless the unit is 1 or kCompactUnit.
  void Start(const VolumeShape& shape, const RadiometricFit& fit, int unit);
  // Then both, in any order or at once, before costs are asked for. Images: CV_8UC1 of the size of
  // the shape.
  void PrepareLeft(const cv::Mat& left, ThreadPool* pool);
  void PrepareRight(const cv::Mat& right, ThreadPool* pool);

  const VolumeShape& shape() const override { return shape_; }
  int unit() const override { return unit_; }
  const std::uint8_t* Row(int y, int x_begin, int x_end, std::uint8_t* scratch) const override;

  static std::size_t Memory(const VolumeShape& shape);

 private:
  VolumeShape shape_;
  int unit_ = 1;
  RadiometricFit fit_;
  std::uint8_t ad_limit_ = 0;
  PaddedGray left_image_;
  PaddedGray right_image_;
  FeaturePlanes left_;
  FeaturePlanes right_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_MIXED_COST_H_
