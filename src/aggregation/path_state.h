#ifndef STEREO_SGMP_AGGREGATION_PATH_STATE_H_
#define STEREO_SGMP_AGGREGATION_PATH_STATE_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "aggregation/paths.h"
#include "common/aligned_buffer.h"

namespace stereo_sgmp {

// What a pixel p sends along a path r, for every disparity index d at which the next pixel may
// receive it: the least cost of arriving there by staying or by a step of one,
//   M_r(p, d) = min(L_r(p, d), L_r(p, d - 1) + P1, L_r(p, d + 1) + P1) - min_d' L_r(p, d').
// The next pixel q adds its own cost, bounded by the penalty of a large step and moved by the jump
// of the prior: L_r(q, d) = C_q(d) + min(M_r(p, d - j), P2).
//
// A message stands in a slot with kUnreachable before and behind, so that kernels read moved
// messages unchecked: a jump needs its start within the range. T is std::uint8_t where C + P2
// never exceeds it, else std::uint16_t.
template <class T>
struct PathSlot {
  static constexpr T kUnreachable = std::numeric_limits<T>::max();
  // Jumps up to it are applied as shifted loads. At least a SIMD vector of lanes.
  static constexpr int kPad = 64;

  static std::size_t Size(int stride) { return static_cast<std::size_t>(stride) + 2 * kPad; }
};

// Half of S(p, d), the sum over the paths of a sweep, is kept as what the path costs exceed their
// least by, sum over r of L_r(p, d) - min_d' L_r(p, d'), in steps of kSumStep<T>: so that it fits
// T.
template <class T>
inline constexpr int kSumStep = sizeof(T) == 1 ? 2 : 1;

// The slots of the paths that come from the row above, for a window of pixels of one row: pixel
// u (in sweep order) has the place u & mask, so that a ring serves as well as a whole row.
template <class T>
struct StateLine {
  static constexpr int kPaths = kPathsPerSweep - 1;  // all but kAcross

  T* first = nullptr;  // of place 0, the message of the first of its paths
  int mask = 0;
  std::ptrdiff_t slot = 0;  // size of a slot

  // The message of the first of its paths.
  T* Pixel(int u) const { return first + (u & mask) * (kPaths * slot); }

  T* Message(int u, int path) const { return Pixel(u) + (path - 1) * slot; }
};

// Memory of a StateLine for `places` pixels: a ring, of a power of two, or a whole row. A whole row
// has the start of paths before and behind it; in a ring that has to be set when it is needed.
template <class T>
class StateLineBuffer {
 public:
  void Create(int places, int disparities, int stride, bool is_ring) {
    const std::size_t slot = PathSlot<T>::Size(stride);
    const std::size_t size = Slots(places) * slot;
    const bool same_layout = slots_.size() == size &&
                             line_.slot == static_cast<std::ptrdiff_t>(slot) &&
                             disparities_ == disparities;
    disparities_ = disparities;
    has_moved_ = false;
    slots_.Resize(size);
    if (!same_layout) std::fill_n(slots_.data(), size, PathSlot<T>::kUnreachable);
    line_.first = slots_.data() + StateLine<T>::kPaths * slot + PathSlot<T>::kPad;
    line_.mask = is_ring ? places - 1 : ~0;
    line_.slot = static_cast<std::ptrdiff_t>(slot);
    SetStart(-1);
    SetStart(places);
  }

  const StateLine<T>& line() const { return line_; }

  // Lets paths start at pixel u: their first message has zeros, which any P2 leaves as they are.
  void SetStart(int u) {
    for (int path = 1; path <= StateLine<T>::kPaths; ++path) {
      std::fill_n(line_.Message(u, path), disparities_, T{0});
    }
  }

  // Whether the prior has moved its messages already: a sweep from here may be repeated.
  bool has_moved() const { return has_moved_; }
  void SetMoved() { has_moved_ = true; }

  static std::size_t Bytes(int places, int stride) {
    return Slots(places) * PathSlot<T>::Size(stride) * sizeof(T);
  }

 private:
  static std::size_t Slots(int places) {
    return (static_cast<std::size_t>(places) + 2) * StateLine<T>::kPaths;
  }

  AlignedBuffer<T> slots_;
  StateLine<T> line_;
  int disparities_ = 0;
  bool has_moved_ = false;
};

// The slots of the path along the row: the pixel before and the pixel itself take turns.
template <class T>
struct AcrossState {
  T* before = nullptr;
  T* here = nullptr;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_AGGREGATION_PATH_STATE_H_
