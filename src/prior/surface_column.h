// Disparity surfaces at one pixel: the column (p, d) of the paper's 3D prior (Sec. 3.3).
#ifndef STEREO_SGMP_PRIOR_SURFACE_COLUMN_H_
#define STEREO_SGMP_PRIOR_SURFACE_COLUMN_H_

#include <array>
#include <cstddef>
#include <limits>

#include "prior/plane_sets.h"

namespace stereo_sgmp {

// The rasterised surfaces S^_k(p) of a pixel in rising order, and the Voronoi cells they cut the
// disparities into: each disparity belongs to the nearest surface, to the lower one of two at the
// same distance. Of surfaces that round to one disparity only the first given has a cell.
class SurfaceColumn {
 public:
  static constexpr int kMaxSurfaces = 32;
  // Largest |S^| that Assign takes, far outside of any search range.
  static constexpr int kMaxValue = 1 << 25;
  static constexpr int kNoEnd = std::numeric_limits<int>::max();

  // A single number to sort by: S^_k(p), within +-kMaxValue, then the order k given.
  static int Key(int value, std::size_t k) { return value * kMaxSurfaces + static_cast<int>(k); }
  static std::size_t SurfaceOf(int key) {
    return static_cast<std::size_t>(key & (kMaxSurfaces - 1));
  }

  // The keys of `count` <= kMaxSurfaces surfaces, rising.
  void Assign(const int* keys, std::size_t count) {
    cells_ = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto surface = static_cast<int>(SurfaceOf(keys[i]));
      const int value = (keys[i] - surface) / kMaxSurfaces;
      if (cells_ > 0 && value == value_[Slot(cells_ - 1)]) continue;
      value_[Slot(cells_)] = value;
      surface_[Slot(cells_)] = surface;
      ++cells_;
    }
  }

  int cells() const { return cells_; }
  int value(int cell) const { return value_[Slot(cell)]; }
  int surface(int cell) const { return surface_[Slot(cell)]; }

  // The first disparity that is nearer to the surface of the next cell.
  int CellEnd(int cell) const {
    if (cell + 1 == cells_) return kNoEnd;
    return FirstNearer(value(cell), value(cell + 1));
  }

  // The first disparity that is nearer to the surface at `above` than to that at `below`.
  static int FirstNearer(int below, int above) {
    const int sum = below + above;
    return (sum >= 0 ? sum / 2 : -((1 - sum) / 2)) + 1;  // floor of the midpoint, plus 1
  }

 private:
  static_assert(kMaxSurfaces >= PlaneSet::kMaxPlanes, "a column holds all planes of a set");
  static_assert((kMaxSurfaces & (kMaxSurfaces - 1)) == 0, "keys are split by their lowest bits");
  static std::size_t Slot(int cell) { return static_cast<std::size_t>(cell); }

  int cells_ = 0;
  // Set up to cells_. Clearing the rest would take longer than all that is done with a column.
  std::array<int, kMaxSurfaces> value_;    // NOLINT(cppcoreguidelines-pro-type-member-init)
  std::array<int, kMaxSurfaces> surface_;  // NOLINT(cppcoreguidelines-pro-type-member-init)
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_SURFACE_COLUMN_H_
