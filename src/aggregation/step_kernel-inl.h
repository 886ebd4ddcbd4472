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

// The message along the row, which most pixels receive as it is.
template <class T, class Shape>
HWY_NOINLINE void MoveAcross(const SweepStretch<T>& s, const Shape& shape, std::ptrdiff_t entry,
                             T* message) {
  MoveOnPath<T>(s, shape, kAcross, entry, message);
}

// The pixels that the prior moves the messages of one path to: bit i for entry i of `moves`, of up
// to 8 entries.
HWY_INLINE std::uint32_t MovesOnPath(const std::uint8_t* moves, int path) {
  std::uint64_t bytes = 0;
  for (int i = 0; i < 8; ++i) bytes |= std::uint64_t{moves[i]} << (8 * i);
  // Gathers the lowest bits of the bytes in the highest byte.
  const std::uint64_t lowest = (bytes >> path) & 0x0101010101010101;
  return static_cast<std::uint32_t>((lowest * 0x0102040810204080) >> 56);
}

// Bits of the pixels of a stretch, in the order of the image, that receive a message on the path
// from a pixel of the row above.
template <class T>
HWY_INLINE std::uint32_t ReceivingPixels(const SweepStretch<T>& s, int path) {
  const int count = s.Count();
  const std::uint32_t all = (std::uint32_t{1} << count) - 1;
  const auto without = [&](int u) {
    const int place = s.IsForward() ? u - s.u_begin : s.u_end - 1 - u;
    return all & ~(std::uint32_t{1} << place);
  };
  if (kFrom[path] < 0 && s.u_begin == 0) return without(0);
  if (kFrom[path] > 0 && s.u_end == s.width) return without(s.width - 1);
  return all;
}

// Moves what the pixels receive from the row above, before any of them does: so the moves need
// not wait for each other, nor for a guess which pixels have one.
template <class T, class Shape>
HWY_NOINLINE void MoveFromAbove(const SweepStretch<T>& s, const Shape& shape) {
  static_assert(SweepStretch<T>::kMaxPixels <= 16, "two parts of 8 pixels");
  // Of the first pixel in the order of the image, its entry and its place in the sweep.
  const std::ptrdiff_t first_entry = s.IsForward() ? s.first_jump : s.first_jump - (s.Count() - 1);
  const int first = s.IsForward() ? s.u_begin : s.u_end - 1;
  const std::uint8_t* const entries = s.moves + first_entry;
  for (int path = kAcross + 1; path < s.paths; ++path) {
    std::uint32_t pixels = MovesOnPath(entries, path) | (MovesOnPath(entries + 8, path) << 8);
    pixels &= ReceivingPixels(s, path);
    for (; pixels != 0; pixels &= pixels - 1) {
      const int place = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero32(pixels));
      const int from = first + s.x_step * place + kFrom[path];
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
      MoveAcross<T>(s_, shape_, s_.first_jump + offset, before_);
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
