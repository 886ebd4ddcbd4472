#ifndef STEREO_SGMP_PRIOR_PLANE_COLUMNS_H_
#define STEREO_SGMP_PRIOR_PLANE_COLUMNS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "prior/fixed_plane.h"
#include "prior/plane_sets.h"
#include "prior/surface_column.h"

namespace stereo_sgmp {

// The columns of pixels of one row at which one set of planes holds. Planes that don't cross keep
// their order from pixel to pixel, so that sorting them again takes little.
class PlaneColumns {
 public:
  // From the pixel (x, y) on.
  PlaneColumns(const std::vector<FixedPlane>& planes, const PlaneSet& set, int x, int y)
      : count_(set.count) {
    for (std::size_t k = 0; k < set.count; ++k) {
      const FixedPlane& plane = planes[static_cast<std::size_t>(set.planes[k])];
      values_[k] = plane.FixedAt(x, y);
      slopes_[k] = plane.FixedSlope();
      keys_[k] = static_cast<int>(k);
    }
  }

  // The column of the i-th pixel; valid until the next call.
  const SurfaceColumn& At(int i) {
    for (std::size_t n = 0; n < count_; ++n) {
      const std::size_t k = SurfaceColumn::SurfaceOf(keys_[n]);
      const int key = SurfaceColumn::Key(RoundedAt(k, i), k);
      std::size_t place = n;
      for (; place > 0 && keys_[place - 1] > key; --place) keys_[place] = keys_[place - 1];
      keys_[place] = key;
    }
    column_.Assign(keys_.data(), count_);
    return column_;
  }

 private:
  int RoundedAt(std::size_t k, int i) const {
    return static_cast<int>((values_[k] + slopes_[k] * i) >> FixedPlane::kFractionBits);
  }

  std::size_t count_;
  // Set up to count_. Clearing the rest would take longer than all that is done with a column.
  std::array<std::int64_t, PlaneSet::kMaxPlanes> values_;  // NOLINT: 2^-32, of the first pixel
  std::array<std::int64_t, PlaneSet::kMaxPlanes> slopes_;  // NOLINT: from pixel to pixel
  std::array<int, PlaneSet::kMaxPlanes> keys_;             // NOLINT: of the last column, rising
  SurfaceColumn column_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_PLANE_COLUMNS_H_
