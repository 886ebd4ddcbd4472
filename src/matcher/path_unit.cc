#include "matcher/path_unit.h"

#include "aggregation/penalties.h"
#include "cost/cost_unit.h"
#include "cost/mixed_cost.h"

namespace stereo_sgmp {

int PathUnit(const Options& options, bool given_costs) {
  if (options.aggregation.path_costs == PathCosts::kFull) return 1;
  const int smallest = CompactUnit(options.aggregation);
  if (!given_costs && options.cost.kind == CostKind::kMixed) {
    return smallest <= MixedCost::kCompactUnit ? MixedCost::kCompactUnit : 1;
  }
  return smallest <= kMaxCostUnit ? smallest : 1;
}

}  // namespace stereo_sgmp
