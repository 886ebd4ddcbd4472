#ifndef STEREO_SGMP_COST_VOLUME_COST_H_
#define STEREO_SGMP_COST_VOLUME_COST_H_

#include <cstdint>

#include "cost/cost_rows.h"
#include "stereo_sgmp/cost_volume.h"

namespace stereo_sgmp {

// Costs that were made elsewhere.
class VolumeCost final : public CostRows {
 public:
  // `volume` must outlive the object. Throws std::invalid_argument, saying what to set, when it is
  // not of the shape that is wanted.
  VolumeCost(const CostVolume& volume, const VolumeShape& wanted);

  const VolumeShape& shape() const override { return shape_; }
  const std::uint8_t* Row(int y, int x_begin, int x_end, std::uint8_t* scratch) const override;

 private:
  const CostVolume* volume_;
  VolumeShape shape_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_VOLUME_COST_H_
