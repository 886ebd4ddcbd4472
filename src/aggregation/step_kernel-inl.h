// Where the messages that a pixel receives stand, and where those it sends go.
#if defined(STEREO_SGMP_AGGREGATION_STEP_KERNEL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef STEREO_SGMP_AGGREGATION_STEP_KERNEL_INL_H_
#undef STEREO_SGMP_AGGREGATION_STEP_KERNEL_INL_H_
#else
#define STEREO_SGMP_AGGREGATION_STEP_KERNEL_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <utility>

#include "aggregation/jump_kernel-inl.h"
#include "aggregation/message_kernel-inl.h"
#include "aggregation/path_state.h"
#include "aggregation/sweep_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {

// Pixels of the row above by path: straight on, from behind, from ahead.
inline constexpr int kFrom[kPathsPerSweep] = {0, 0, -1, 1};

// Moves the message of one path to the pixel with the jumps `entry`.
template <class T, class Shape>
HWY_INLINE void MoveOnPath(const SweepStretch<T>& s, const Shape& shape, int path,
                           std::ptrdiff_t entry, T* message) {
  const Journey<T> journey{message, s.disparities, s.all_disparities, s.jump_slack};
  MoveMessage<T>(shape, (*s.jumps)[static_cast<std::size_t>(path)], static_cast<std::size_t>(entry),
                 journey, s.moved + PathSlot<T>::kPad);
}

// Which of `count` pixels the prior moves the messages from the row above for: bit `path` of byte i
// for pixel i, of up to 8 pixels.
HWY_INLINE std::uint64_t MovesFromAbove(const std::uint8_t* moves, int count) {
  static_assert(kAcross == 0, "the lowest bit of each byte is not from above");
  std::uint64_t bytes = 0;
  for (int i = 0; i < 8; ++i) bytes |= std::uint64_t{moves[i]} << (8 * i);
  if (count < 8) bytes &= (std::uint64_t{1} << (8 * count)) - 1;
  return bytes & ~std::uint64_t{0x0101010101010101};
}

// Moves what the pixels receive from the row above, before any of them does: so the moves need
// not wait for each other, nor for a guess which pixels have one.
template <class T, class Shape>
HWY_INLINE void MoveFromAbove(const SweepStretch<T>& s, const Shape& shape) {
  const int count = s.Count();
  // Of the first pixel in the order of the image, its entry and its place in the sweep.
  const std::ptrdiff_t first_entry = s.IsForward() ? s.first_jump : s.first_jump - (count - 1);
  const int first = s.IsForward() ? s.u_begin : s.u_end - 1;
  for (int begin = 0; begin < count; begin += 8) {
    std::uint64_t moves = MovesFromAbove(s.moves + first_entry + begin, count - begin);
    for (; moves != 0; moves &= moves - 1) {
      const int bit = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(moves));
      const int path = bit % 8;
      const int place = begin + bit / 8;
      const int from = first + s.x_step * place + kFrom[path];
      if (HWY_UNLIKELY(from < 0 || from >= s.width)) continue;
      MoveOnPath<T>(s, shape, path, first_entry + place, s.above.Message(from, path));
    }
  }
}

// Goes along the pixels of a stretch.
template <class T, int kPaths, class Shape>
class StepCursor {
 public:
  StepCursor(const SweepStretch<T>& s, const Shape& shape)
      : s_(s), shape_(shape), before_(s.across->before), here_(s.across->here) {}

  // The steps to pixel u, which stands `offset` pixels from the first one.
  HWY_INLINE void Prepare(int u, std::ptrdiff_t offset, PathStepState<T> (&steps)[kPaths]) const {
    T* sent = s_.current.Pixel(u);
    steps[kAcross].sent = here_;
    for (int path = kAcross + 1; path < kPaths; ++path) {
      steps[path].sent = sent + (path - 1) * static_cast<std::ptrdiff_t>(s_.current.slot);
    }
    if (HWY_LIKELY(s_.has_above && u > 0 && u + 1 < s_.width)) {
      for (int path = 0; path < kPaths; ++path) Receive(path, u, offset, &steps[path]);
    } else {
      ReceiveAtEdge(u, offset, steps);
    }
    if (s_.moves == nullptr) return;
    const std::ptrdiff_t entry = s_.first_jump + offset;
    if ((s_.moves[entry] >> kAcross & 1) != 0 && u > 0) {
      MoveOnPath<T>(s_, shape_, kAcross, entry, before_);
    }
  }

  HWY_INLINE void Advance() { std::swap(before_, here_); }

  // Leaves the message of the last pixel to the next stretch.
  HWY_INLINE void Finish() const {
    s_.across->before = before_;
    s_.across->here = here_;
  }

 private:
  HWY_INLINE void Receive(int path, int u, std::ptrdiff_t offset, PathStepState<T>* step) const {
    step->received = path == kAcross ? before_ : s_.above.Message(u + kFrom[path], path);
    step->p2 = s_.p2 + s_.contrast[static_cast<std::size_t>(path)][offset];
  }

  // Paths start with a message of zeros, which any P2 leaves as it is.
  void ReceiveAtEdge(int u, std::ptrdiff_t offset, PathStepState<T> (&steps)[kPaths]) const {
    for (int path = 0; path < kPaths; ++path) {
      const int from = u + kFrom[path];
      const bool starts = path == kAcross ? u == 0 : !s_.has_above || from < 0 || from >= s_.width;
      if (starts) {
        steps[path].received = s_.start;
        steps[path].p2 = s_.p2;
      } else {
        Receive(path, u, offset, &steps[path]);
      }
    }
  }

  const SweepStretch<T>& s_;
  const Shape& shape_;
  T* before_;
  T* here_;
};

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
