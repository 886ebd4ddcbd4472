#ifndef STEREO_SGMP_AGGREGATION_PENALTIES_H_
#define STEREO_SGMP_AGGREGATION_PENALTIES_H_

#include <array>

#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// The penalties of the smoothness term V(d, d') (Eq. 2): 0 for equal disparities, P1 for a step
// of one, P2 for larger ones; and what a path pays for not following the prior. In the unit of
// the costs that they are added to, rounded.
struct Penalties {
  int p1 = 0;
  // P2 = P1 (1 + alpha exp(-|dI| / beta)) by the contrast |dI| of the two pixels.
  std::array<int, 256> p2{};
  int slack = -1;  // less than 0: the prior must be followed

  // `jump_slack` as in PriorOptions.
  Penalties(const AggregationOptions& options, int jump_slack, int unit);
};

// The smallest unit of compact costs (CostRows::unit) with which costs and path costs fit 8 bits.
int CompactUnit(const AggregationOptions& options);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_AGGREGATION_PENALTIES_H_
