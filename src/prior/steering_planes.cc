#include "prior/steering_planes.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace stereo_sgmp {
namespace {

// A constant plane has the value of the flat one in the middle of the image.
DisparityPlane Flattened(const DisparityPlane& plane, double min_slope, const VolumeShape& shape) {
  if (std::hypot(plane.a, plane.b) >= min_slope) return plane;
  return {0.0, 0.0, plane.At(shape.width / 2.0, shape.height / 2.0)};
}

// The planes of `set`, then their copies, which stand `step` and two steps further in the list.
PlaneSet WithCopies(const PlaneSet& set, std::size_t step) {
  PlaneSet copies;
  for (std::size_t phase = 0; phase < PlaneSet::kPhases; ++phase) {
    for (std::size_t k = 0; k < set.count; ++k) {
      const auto plane = static_cast<std::size_t>(set.planes[k]) + phase * step;
      copies.planes[copies.count++] = static_cast<std::int16_t>(plane);
    }
  }
  return copies;
}

}  // namespace

void SteeringPlanes::Assign(const PriorOptions& options, const std::vector<DisparityPlane>& found,
                            const PlaneSets& sets, const VolumeShape& shape) {
  planes_.clear();
  for (const DisparityPlane& plane : found) {
    planes_.push_back(Flattened(plane, options.min_slope, shape));
  }
  empty_ = found.empty();
  if (empty_) return;
  parallel_.Assign(planes_, sets, shape, options.jump_policy);
  sets_.ids = sets.ids;  // the same image: it is only read
  sets_.sets = sets.sets;
  if (options.attraction > 0.0) AddCopies(options.attraction);
  attracting_.Assign(planes_, sets_, shape, options.jump_policy);
}

void SteeringPlanes::AddCopies(double attraction) {
  const std::size_t found = planes_.size();
  for (const double offset : {-attraction, attraction}) {
    for (std::size_t i = 0; i < found; ++i) {
      planes_.push_back({planes_[i].a, planes_[i].b, planes_[i].c + offset});
    }
  }
  for (PlaneSet& set : sets_.sets) set = WithCopies(set, found);
}

}  // namespace stereo_sgmp
