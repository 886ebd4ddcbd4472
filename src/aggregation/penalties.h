#ifndef STEREO_SGMP_AGGREGATION_PENALTIES_H_
#define STEREO_SGMP_AGGREGATION_PENALTIES_H_

#include <array>
#include <cstdint>

#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// The penalties of the smoothness term V(d, d') (Eq. 2): 0 for equal disparities, P1 for a step
// of one, P2 for larger ones.
struct Penalties {
  std::uint16_t p1 = 0;
  // P2 = P1 (1 + alpha exp(-|dI| / beta)) by the contrast |dI| of the two pixels.
  std::array<std::uint16_t, 256> p2{};

  explicit Penalties(const AggregationOptions& options);
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_AGGREGATION_PENALTIES_H_
