#include "cost/volume_cost.h"

#include <cstddef>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include "cost/compact_kernel.h"
#include "cost/cost_unit.h"

namespace stereo_sgmp {
namespace {

void CheckSize(const CostVolume& volume, const VolumeShape& wanted) {
  if (volume.width == wanted.width && volume.height == wanted.height) return;
  std::ostringstream message;
  message << "The cost volume is of " << volume.width << " x " << volume.height
          << " pixels, but the images have " << wanted.width << " x " << wanted.height
          << "; take the volume of this pair.";
  throw std::invalid_argument(message.str());
}

void CheckRange(const char* option, int found, int wanted) {
  if (found == wanted) return;
  std::ostringstream message;
  message << option << " is " << wanted << ", but that of the cost volume is " << found << "; set "
          << option << " to " << found << '.';
  throw std::invalid_argument(message.str());
}

void CheckCosts(const CostVolume& volume) {
  const std::size_t expected = static_cast<std::size_t>(volume.width) *
                               static_cast<std::size_t>(volume.height) *
                               static_cast<std::size_t>(volume.disparities);
  if (volume.costs.size() == expected) return;
  std::ostringstream message;
  message << "The cost volume holds " << volume.costs.size() << " costs, but its shape needs "
          << expected << "; fill it.";
  throw std::invalid_argument(message.str());
}

}  // namespace

VolumeCost::VolumeCost(const CostVolume& volume, const VolumeShape& wanted, int unit)
    : volume_(&volume), shape_(wanted), unit_(unit) {
  CheckCostUnit(unit);
  CheckSize(volume, wanted);
  CheckRange("num_disparities", volume.disparities, wanted.disparities);
  CheckRange("min_disparity", volume.min_disparity, wanted.min_disparity);
  CheckCosts(volume);
}

const std::uint8_t* VolumeCost::Row(int y, int x_begin, int x_end, std::uint8_t* scratch) const {
  const auto disparities = static_cast<std::size_t>(shape_.disparities);
  std::uint8_t* padded = scratch;
  for (int x = x_begin; x < x_end; ++x) {
    std::memcpy(padded, volume_->At(y, x), disparities);
    padded += shape_.Stride();
  }
  CompactCosts(unit_, static_cast<std::size_t>(padded - scratch), scratch);
  return scratch;
}

}  // namespace stereo_sgmp
