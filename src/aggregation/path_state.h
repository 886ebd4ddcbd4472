#ifndef STEREO_SGMP_AGGREGATION_PATH_STATE_H_
#define STEREO_SGMP_AGGREGATION_PATH_STATE_H_

#include <cstddef>
#include <cstdint>

#include "aggregation/paths.h"
#include "common/aligned_buffer.h"

namespace stereo_sgmp {

// Path costs L_r(p, d) of one pixel and path over all disparity indices stand in a slot, with
// kUnreachable before and behind, so that kernels read d - 1, d + 1 and small jumps unchecked.
struct PathSlot {
  static constexpr std::uint16_t kUnreachable = 0x7FFF;
  // Jumps below it are applied as shifted loads.
  static constexpr int kPad = 32;

  static std::size_t Size(int stride) { return static_cast<std::size_t>(stride) + 2 * kPad; }
};

// The slots of the paths that come from the row above, for a window of pixels of one row: pixel
// u (in sweep order) has the place u & mask, so that a ring serves as well as a whole row.
struct StateLine {
  std::uint16_t* costs = nullptr;
  std::uint16_t* minima = nullptr;  // min_d L_r
  unsigned mask = 0;
  std::size_t slot = 0;  // size of a slot

  static constexpr int kPaths = kPathsPerSweep - 1;  // all but kAcross

  std::size_t Index(int u, int path) const {
    return static_cast<std::size_t>(static_cast<unsigned>(u) & mask) * kPaths +
           static_cast<std::size_t>(path - 1);
  }
  std::uint16_t* Costs(int u, int path) const {
    return costs + Index(u, path) * slot + PathSlot::kPad;
  }
  std::uint16_t& Minimum(int u, int path) const { return minima[Index(u, path)]; }
};

// Memory of a StateLine for `places` pixels: a ring, of a power of two, or a whole row.
class StateLineBuffer {
 public:
  void Create(int places, int disparities, int stride, bool is_ring);
  const StateLine& line() const { return line_; }
  static std::size_t Bytes(int places, int stride);

 private:
  AlignedBuffer<std::uint16_t> costs_;
  AlignedBuffer<std::uint16_t> minima_;
  StateLine line_;
  int disparities_ = 0;
};

// The slots of the path along the row: the pixel before and the pixel itself take turns.
struct AcrossState {
  std::uint16_t* before = nullptr;  // L_r of the pixel before
  std::uint16_t* here = nullptr;
  std::uint16_t minimum = 0;  // min_d of `before`
};

// Writes kUnreachable around (and into) `count` slots that follow each other.
void FillUnreachable(std::uint16_t* slots, std::size_t count, std::size_t slot);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_AGGREGATION_PATH_STATE_H_
