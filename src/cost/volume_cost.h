#ifndef STEREO_SGMP_COST_VOLUME_COST_H_
#define STEREO_SGMP_COST_VOLUME_COST_H_

#include <cstdint>

#include "cost/cost_rows.h"
#include "stereo_sgmp/cost_volume.h"

namespace stereo_sgmp {

// Costs that were made elsewhere.
class VolumeCost final : public CostRows {
 public:
  // `volume` must outlive the object; its costs are full ones, Row gives the CompactCost of them.
  // Throws std::invalid_argument, saying what to set, when it is not of the shape that is wanted,
  // and for a unit out of range.
  VolumeCost(const CostVolume& volume, const VolumeShape& wanted, int unit);

  const VolumeShape& shape() const override { return shape_; }
  int unit() const override { return unit_; }
  const std::uint8_t* Row(int y, int x_begin, int x_end, std::uint8_t* scratch) const override;

 private:
  const CostVolume* volume_;
  VolumeShape shape_;
  int unit_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_VOLUME_COST_H_
