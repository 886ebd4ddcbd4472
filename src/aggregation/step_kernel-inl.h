// Where the messages that a pixel receives stand, and where those it sends go.
#if defined(STEREO_SGMP_AGGREGATION_STEP_KERNEL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef STEREO_SGMP_AGGREGATION_STEP_KERNEL_INL_H_
#undef STEREO_SGMP_AGGREGATION_STEP_KERNEL_INL_H_
#else
#define STEREO_SGMP_AGGREGATION_STEP_KERNEL_INL_H_
#endif

#include <hwy/highway.h>

#include <array>
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
  const Journey<T> journey{message, s.disparities, s.all_disparities, s.price_of_staying};
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

// Goes along the pixels of a stretch. What it needs of that is kept here, since messages that are
// stored could change it for all that the compiler knows; and each step is looked up when it is
// taken, since all at once don't fit the registers.
template <class T, class Shape>
class StepCursor {
 public:
  StepCursor(const SweepStretch<T>& s, const Shape& shape)
      : s_(s),
        shape_(shape),
        above_(s.above),
        current_(s.current),
        p2_(s.p2),
        contrast_(s.contrast),
        moves_(s.moves == nullptr ? nullptr : s.moves + s.first_jump),
        before_(s.across->before),
        here_(s.across->here),
        straight_on_(above_.Pixel(s.u_begin - 1)),
        ahead_(above_.Pixel(s.u_begin)) {}

  // Goes on to pixel u, which stands `offset` pixels from the first one.
  HWY_INLINE void Enter(int u, std::ptrdiff_t offset) {
    behind_ = straight_on_;
    straight_on_ = ahead_;
    ahead_ = above_.Pixel(u + 1);
    sent_ = current_.Pixel(u);
    offset_ = offset;
    if (moves_ != nullptr && (moves_[offset] >> kAcross & 1) != 0 && u > 0) {
      MoveOnPath<T>(s_, shape_, kAcross, s_.first_jump + offset, before_);
    }
  }

  // The step of one path to the pixel.
  HWY_INLINE PathStepState<T> Step(int path) const {
    return {Received(path), p2_ + contrast_[static_cast<std::size_t>(path)][offset_], Sent(path)};
  }

  // Where the message goes that one path sends on from the pixel.
  HWY_INLINE T* Sent(int path) const {
    return path == kAcross ? here_ : sent_ + (path - 1) * current_.slot;
  }

  HWY_INLINE void Leave() { std::swap(before_, here_); }

  // Leaves the message of the last pixel to the next stretch.
  HWY_INLINE void Finish() const {
    s_.across->before = before_;
    s_.across->here = here_;
  }

 private:
  HWY_INLINE const T* Received(int path) const {
    if (path == kAcross) return before_;
    const T* const from[] = {behind_, straight_on_, ahead_};
    return from[kFrom[path] + 1] + (path - 1) * above_.slot;
  }

  const SweepStretch<T>& s_;
  const Shape& shape_;
  const StateLine<T> above_;
  const StateLine<T> current_;
  const T* const p2_;
  const std::array<const std::uint8_t*, kPathsPerSweep> contrast_;
  const std::uint8_t* const moves_;
  T* before_;  // on the path along the row, as AcrossState has them
  T* here_;
  T* behind_ = nullptr;  // of the row above, the first messages of the pixels around
  T* straight_on_;
  T* ahead_;
  T* sent_ = nullptr;
  std::ptrdiff_t offset_ = 0;
};

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
