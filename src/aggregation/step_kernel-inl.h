// Where the messages that a pixel receives stand, and where those it sends go.
#if defined(STEREO_SGMP_AGGREGATION_STEP_KERNEL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef STEREO_SGMP_AGGREGATION_STEP_KERNEL_INL_H_
#undef STEREO_SGMP_AGGREGATION_STEP_KERNEL_INL_H_
#else
#define STEREO_SGMP_AGGREGATION_STEP_KERNEL_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <utility>

#include "aggregation/jump_kernel-inl.h"
#include "aggregation/message_kernel-inl.h"
#include "aggregation/path_state.h"
#include "aggregation/sweep_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {

// Goes along the pixels of a stretch.
template <class T, int kPaths>
class StepCursor {
 public:
  explicit StepCursor(const SweepStretch<T>& s)
      : s_(s), before_(s.across->before), here_(s.across->here) {}

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
    if (s_.moves[entry] != 0) Move(entry, steps);
  }

  HWY_INLINE void Advance() { std::swap(before_, here_); }

  // Leaves the message of the last pixel to the next stretch.
  HWY_INLINE void Finish() const {
    s_.across->before = before_;
    s_.across->here = here_;
  }

 private:
  // Pixels of the row above by path: straight on, from behind, from ahead.
  static constexpr int kFrom[kPathsPerSweep] = {0, 0, -1, 1};

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

  // What the prior moves; nothing where a path starts.
  HWY_INLINE void Move(std::ptrdiff_t entry, PathStepState<T> (&steps)[kPaths]) const {
    for (int path = 0; path < kPaths; ++path) {
      if ((s_.moves[entry] >> path & 1) == 0 || steps[path].received == s_.start) continue;
      const Journey<T> journey{steps[path].received, s_.disparities, s_.all_disparities,
                               s_.jump_slack};
      steps[path].received = MoveMessage<T>(
          (*s_.jumps)[static_cast<std::size_t>(path)], static_cast<std::size_t>(entry), journey,
          s_.moved + path * static_cast<std::ptrdiff_t>(s_.current.slot));
    }
  }

  const SweepStretch<T>& s_;
  T* before_;
  T* here_;
};

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
