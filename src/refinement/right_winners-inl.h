// The winners of the right pixels that left pixels match, for kernels: which pixels those are is
// found for whole vectors, and so is what is done with the winners; only they themselves are
// read one by one in between. Included once per SIMD target.
#if defined(STEREO_SGMP_REFINEMENT_RIGHT_WINNERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef STEREO_SGMP_REFINEMENT_RIGHT_WINNERS_INL_H_
#undef STEREO_SGMP_REFINEMENT_RIGHT_WINNERS_INL_H_
#else
#define STEREO_SGMP_REFINEMENT_RIGHT_WINNERS_INL_H_
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "aggregation/winner_map.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Of a stretch of a row.
class RightWinners {
 public:
  static constexpr int kMost = 512;  // pixels; a multiple of all vector lengths

  // Row of the right winners, and its length.
  RightWinners(const std::uint16_t* row, int width) : row_(row), width_(width) {}

  // The pixels from i on match the columns `match`.
  template <class DI>
  HWY_INLINE void SetMatches(DI di, int i, hn::Vec<DI> match) {
    const hn::Rebind<std::uint16_t, DI> d16;
    const auto inside = hn::And(hn::Gt(match, hn::Set(di, -1)), hn::Lt(match, hn::Set(di, width_)));
    hn::StoreU(hn::IfThenElseZero(inside, match), di, column_ + i);
    const auto outside = hn::IfThenZeroElse(inside, hn::Set(di, WinnerMap::kNone));
    hn::StoreU(hn::DemoteTo(d16, outside), d16, outside_ + i);
  }

  // Reads the winners of the first `count` pixels, which have their matches.
  HWY_INLINE void Read(int count) {
    for (int i = 0; i < count; ++i) winner_[i] = row_[column_[i]];
  }

  // The winners of the pixels from i on; WinnerMap::kNone too where the match lies outside.
  template <class D16>
  HWY_INLINE hn::Vec<D16> Winners(D16 d16, int i) const {
    return hn::Or(hn::LoadU(d16, winner_ + i), hn::LoadU(d16, outside_ + i));
  }

 private:
  const std::uint16_t* row_;
  int width_;
  std::int32_t column_[kMost];
  std::uint16_t outside_[kMost];  // all bits where the match lies outside, else 0
  std::uint16_t winner_[kMost];
};

// Calls body(x, count) for stretches of a row of `width` pixels, at least `lanes`, each of a
// multiple of `lanes`. The last may overlap the one before.
template <class Body>
HWY_INLINE void ForStretches(int width, int lanes, const Body& body) {
  const int whole = width / lanes * lanes;
  for (int x = 0; x < whole; x += RightWinners::kMost) {
    body(x, HWY_MIN(RightWinners::kMost, whole - x));
  }
  if (whole < width) body(width - lanes, lanes);
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // STEREO_SGMP_REFINEMENT_RIGHT_WINNERS_INL_H_
