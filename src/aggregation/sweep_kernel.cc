#include "aggregation/sweep_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aggregation/sweep_kernel.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "aggregation/jump_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D16 = hn::ScalableTag<std::uint16_t>;
using D8 = hn::Rebind<std::uint8_t, D16>;
using V16 = hn::Vec<D16>;

constexpr std::uint16_t kLargest = 0xFFFF;

// Smallest lane. Halves down to 128 bits first, where x86 and Arm have an instruction for it.
template <class D>
HWY_INLINE std::uint16_t ReduceMin(D d, hn::Vec<D> v) {
#if HWY_TARGET != HWY_SCALAR
  if constexpr (hn::MaxLanes(D()) > 8) {
    const hn::Half<D> half;
    return ReduceMin(half, hn::Min(hn::LowerHalf(half, v), hn::UpperHalf(half, v)));
  }
#endif
  return hn::GetLane(hn::MinOfLanes(d, v));
}

// One path at one pixel: its predecessor as the transition sees it, and where its costs go.
struct PathStepState {
  const std::uint16_t* predecessor;
  std::uint16_t* costs;
  std::uint16_t predecessor_minimum;
  std::uint16_t p2;
};

// L_r(p, d) = C_p(d) + min over d' of (L_r(p - r, d') + V(d', d)) - min L_r(p - r), Eq. 3.
HWY_INLINE V16 PathCosts(const std::uint16_t* predecessor, V16 cost, V16 p1, V16 minimum,
                         V16 minimum_p2) {
  const D16 d;
  const V16 same = hn::LoadU(d, predecessor);
  const V16 step = hn::Min(hn::LoadU(d, predecessor - 1), hn::LoadU(d, predecessor + 1));
  const V16 best = hn::Min(hn::Min(same, hn::Add(step, p1)), minimum_p2);
  return hn::Add(cost, hn::Sub(best, minimum));
}

// Advances kPaths paths to one pixel. `finish(k, S_of_the_paths, mask of valid lanes)` receives
// the sum of the path costs of each vector. Returns the sum of min_d L_r; minima go to `minima`.
template <int kPaths, class Finish>
HWY_INLINE void AdvancePaths(const PathStepState (&paths)[kPaths], const std::uint8_t* cost,
                             int disparities, std::uint16_t p1_cost,
                             std::uint16_t (&minima)[kPaths], const Finish& finish) {
  const D16 d;
  const D8 d8;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const V16 p1 = hn::Set(d, p1_cost);
  V16 minimum[kPaths];
  V16 minimum_p2[kPaths];
  V16 smallest[kPaths];
  for (int i = 0; i < kPaths; ++i) {
    minimum[i] = hn::Set(d, paths[i].predecessor_minimum);
    minimum_p2[i] =
        hn::Set(d, static_cast<std::uint16_t>(paths[i].predecessor_minimum + paths[i].p2));
    smallest[i] = hn::Set(d, kLargest);
  }
  const auto advance = [&](int k, auto limit) HWY_ATTR {
    const V16 c = hn::PromoteTo(d, hn::Load(d8, cost + k));
    V16 sum = hn::Zero(d);
    for (int i = 0; i < kPaths; ++i) {
      const V16 costs = limit(PathCosts(paths[i].predecessor + k, c, p1, minimum[i], minimum_p2[i]),
                              PathSlot::kUnreachable);
      hn::Store(costs, d, paths[i].costs + k);
      smallest[i] = hn::Min(smallest[i], costs);
      sum = i == 0 ? costs : hn::Add(sum, costs);
    }
    finish(k, sum, limit);
  };
  int k = 0;
  for (; k + lanes <= disparities; k += lanes) {
    advance(k, [](V16 v, std::uint16_t) HWY_ATTR { return v; });
  }
  if (k < disparities) {
    const auto inside = hn::FirstN(d, static_cast<std::size_t>(disparities - k));
    advance(k, [&](V16 v, std::uint16_t other)
                   HWY_ATTR { return hn::IfThenElse(inside, v, hn::Set(D16(), other)); });
  }
  for (int i = 0; i < kPaths; ++i) minima[i] = ReduceMin(d, smallest[i]);
}

// Moves along a stretch; calls `pixel(i, paths, cost)` for its i-th pixel with the paths' state.
template <int kPaths, class Pixel>
HWY_INLINE void ForEachPixel(const SweepStretch& s, const Pixel& pixel) {
  const std::size_t slot = s.current.slot;
  for (int u = s.u_begin; u < s.u_end; ++u) {
    const int i = u - s.u_begin;
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(i) * s.x_step;
    // Pixels of the row above by path: straight on, from behind, from ahead.
    constexpr int kFrom[kPathsPerSweep] = {0, 0, -1, 1};
    PathStepState paths[kPaths];
    for (int path = 0; path < kPaths; ++path) {
      PathStepState& state = paths[path];
      const int from = u + kFrom[path];
      const bool starts = path == kAcross ? u == 0 : !s.has_above || from < 0 || from >= s.width;
      state.costs = path == kAcross ? s.across->here : s.current.Costs(u, path);
      if (starts) {
        state.predecessor = s.start;
        state.predecessor_minimum = 0;
        state.p2 = 0;
        continue;
      }
      state.predecessor = path == kAcross ? s.across->before : s.above.Costs(from, path);
      state.predecessor_minimum = path == kAcross ? s.across->minimum : s.above.Minimum(from, path);
      state.p2 = s.p2[s.contrast[static_cast<std::size_t>(path)][offset]];
      if (s.jumps != nullptr) {
        const std::size_t entry =
            static_cast<std::size_t>(s.x_step > 0 ? i : s.u_end - s.u_begin - 1 - i);
        state.predecessor = MovePredecessor((*s.jumps)[static_cast<std::size_t>(path)], entry,
                                            state.predecessor, s.disparities, s.jump_slack,
                                            s.moved + static_cast<std::size_t>(path) * slot);
      }
    }
    std::uint16_t minima[kPaths];
    pixel(i, paths, s.cost + offset * s.stride, minima);
    std::swap(s.across->before, s.across->here);
    s.across->minimum = minima[kAcross];
    for (int path = 1; path < kPaths; ++path) s.current.Minimum(u, path) = minima[path];
  }
}

template <int kPaths>
std::uint16_t SumOf(const std::uint16_t (&minima)[kPaths]) {
  int sum = 0;
  for (int i = 0; i < kPaths; ++i) sum += minima[i];
  return static_cast<std::uint16_t>(sum);
}

template <int kPaths>
HWY_INLINE void First(const SweepStretch& s) {
  const D16 d;
  ForEachPixel<kPaths>(s, [&](int i, const PathStepState(&paths)[kPaths], const std::uint8_t* cost,
                              std::uint16_t(&minima)[kPaths]) HWY_ATTR {
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(i) * s.x_step;
    std::uint16_t* sum = s.sum + offset * s.stride;
    AdvancePaths<kPaths>(paths, cost, s.disparities, s.p1, minima,
                         [&](int k, V16 paths_sum, const auto&)
                             HWY_ATTR { hn::Stream(paths_sum, d, sum + k); });
    s.minimum_sum[offset] = SumOf<kPaths>(minima);
  });
}

// Completes S of one pixel in `total` and returns its minimum.
template <int kPaths>
HWY_INLINE std::uint16_t CompleteSum(const SweepStretch& s, const PathStepState (&paths)[kPaths],
                                     const std::uint8_t* cost, const std::uint16_t* sum,
                                     std::uint16_t (&minima)[kPaths], std::uint16_t* total) {
  const D16 d;
  V16 smallest = hn::Set(d, kLargest);
  AdvancePaths<kPaths>(paths, cost, s.disparities, s.p1, minima,
                       [&](int k, V16 paths_sum, const auto& limit) HWY_ATTR {
                         const V16 complete =
                             limit(hn::Add(paths_sum, hn::Load(d, sum + k)), kLargest);
                         hn::Store(complete, d, total + k);
                         smallest = hn::Min(smallest, complete);
                       });
  return ReduceMin(d, smallest);
}

// Index of the first entry equal to `value`, which is there.
HWY_INLINE int IndexOf(const std::uint16_t* values, std::uint16_t value) {
  const D16 d;
  const V16 wanted = hn::Set(d, value);
  for (int k = 0;; k += static_cast<int>(hn::Lanes(d))) {
    const auto found = hn::FindFirstTrue(d, hn::Eq(hn::Load(d, values + k), wanted));
    if (found >= 0) return k + static_cast<int>(found);
  }
}

// Offers S of a left pixel to the right pixels that it can match. Sweeping x downwards meets the
// disparities of a right pixel from large to small, so that `<=` gives ties to the smallest.
HWY_INLINE void OfferToRight(const std::uint16_t* total, int disparities, std::uint16_t* right_cost,
                             std::uint16_t* right_winner) {
  const D16 d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int k = 0; k < disparities; k += lanes) {
    const V16 cost = hn::Load(d, total + k);
    const V16 best = hn::LoadU(d, right_cost + k);
    const auto taken = hn::Eq(hn::Min(cost, best), cost);
    const auto inside = hn::FirstN(d, static_cast<std::size_t>(disparities - k));
    const V16 index = hn::Iota(d, static_cast<std::uint16_t>(k));
    const V16 winner = hn::LoadU(d, right_winner + k);
    hn::StoreU(hn::Min(cost, best), d, right_cost + k);
    hn::StoreU(hn::IfThenElse(hn::And(taken, inside), index, winner), d, right_winner + k);
  }
}

// Smallest entry further than one from `winner`; those within are overwritten.
HWY_INLINE std::uint16_t SecondBest(std::uint16_t* total, int disparities, int winner) {
  const D16 d;
  total[winner] = kLargest;
  if (winner > 0) total[winner - 1] = kLargest;
  if (winner + 1 < disparities) total[winner + 1] = kLargest;
  V16 smallest = hn::Set(d, kLargest);
  for (int k = 0; k < disparities; k += static_cast<int>(hn::Lanes(d))) {
    smallest = hn::Min(smallest, hn::Load(d, total + k));
  }
  return ReduceMin(d, smallest);
}

template <int kPaths>
HWY_INLINE void Last(const SweepStretch& s, const WinnerRow& out) {
  ForEachPixel<kPaths>(s, [&](int i, const PathStepState(&paths)[kPaths], const std::uint8_t* cost,
                              std::uint16_t(&minima)[kPaths]) HWY_ATTR {
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(i) * s.x_step;
    const std::ptrdiff_t x = s.x_first + offset;
    std::uint16_t* total = s.total + PathSlot::kPad;
    const std::uint16_t best =
        CompleteSum<kPaths>(s, paths, cost, s.sum + offset * s.stride, minima, total);
    const int winner = IndexOf(total, best);
    const std::ptrdiff_t right = out.x_origin - x;
    OfferToRight(total, s.disparities, out.right_cost + right, out.right_winner + right);
    out.winner[x] = static_cast<std::uint16_t>(winner);
    out.cost[x] = best;
    out.cost_below[x] = winner > 0 ? total[winner - 1] : kLargest;
    out.cost_above[x] = winner + 1 < s.disparities ? total[winner + 1] : kLargest;
    out.uncertainty[x] =
        static_cast<std::uint16_t>(best - s.minimum_sum[offset] - SumOf<kPaths>(minima));
    out.second[x] = SecondBest(total, s.disparities, winner);
  });
}

// 0.12 as a fraction of 256, and the largest difference whose product with it fits 16 bits.
constexpr std::uint16_t kSharpenWeight = 31;
constexpr std::uint16_t kSharpenLimit = 2114;

template <int kPaths>
HWY_INLINE void Sharpen(const SweepStretch& s, std::uint8_t* sharpened) {
  const D16 d;
  const D8 d8;
  ForEachPixel<kPaths>(s, [&](int i, const PathStepState(&paths)[kPaths], const std::uint8_t* cost,
                              std::uint16_t(&minima)[kPaths]) HWY_ATTR {
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(i) * s.x_step * s.stride;
    std::uint16_t* total = s.total + PathSlot::kPad;
    const V16 best = hn::Set(d, CompleteSum<kPaths>(s, paths, cost, s.sum + offset, minima, total));
    for (int k = 0; k < s.disparities; k += static_cast<int>(hn::Lanes(d))) {
      const V16 above = hn::Min(hn::Sub(hn::Load(d, total + k), best), hn::Set(d, kSharpenLimit));
      const V16 raised = hn::ShiftRight<8>(hn::Mul(above, hn::Set(d, kSharpenWeight)));
      const V16 half = hn::ShiftRight<1>(hn::PromoteTo(d, hn::Load(d8, cost + k)));
      const V16 sum = hn::Min(hn::Add(raised, half), hn::Set(d, std::uint16_t{255}));
      const hn::Rebind<std::int16_t, D16> di16;
      hn::StoreU(hn::DemoteTo(d8, hn::BitCast(di16, sum)), d8, sharpened + offset + k);
    }
  });
}

void First4(const SweepStretch& s) { First<4>(s); }
void First2(const SweepStretch& s) { First<2>(s); }
void Last4(const SweepStretch& s, const WinnerRow& out) { Last<4>(s, out); }
void Last2(const SweepStretch& s, const WinnerRow& out) { Last<2>(s, out); }
void Sharpen2(const SweepStretch& s, std::uint8_t* sharpened) { Sharpen<2>(s, sharpened); }

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(First4);
HWY_EXPORT(First2);
HWY_EXPORT(Last4);
HWY_EXPORT(Last2);
HWY_EXPORT(Sharpen2);

template <>
void SweepFirst<4>(const SweepStretch& stretch) {
  HWY_DYNAMIC_DISPATCH(First4)(stretch);
}
template <>
void SweepFirst<2>(const SweepStretch& stretch) {
  HWY_DYNAMIC_DISPATCH(First2)(stretch);
}
template <>
void SweepLast<4>(const SweepStretch& stretch, const WinnerRow& winners) {
  HWY_DYNAMIC_DISPATCH(Last4)(stretch, winners);
}
template <>
void SweepLast<2>(const SweepStretch& stretch, const WinnerRow& winners) {
  HWY_DYNAMIC_DISPATCH(Last2)(stretch, winners);
}
template <>
void SweepSharpen<2>(const SweepStretch& stretch, std::uint8_t* sharpened) {
  HWY_DYNAMIC_DISPATCH(Sharpen2)(stretch, sharpened);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
