#include "aggregation/penalties.h"

#include <cmath>
#include <cstddef>

namespace stereo_sgmp {
namespace {

int Rounded(double value) { return static_cast<int>(std::lround(value)); }

double LargeStep(const AggregationOptions& options, double contrast) {
  return options.p1 * (1.0 + options.alpha * std::exp(-contrast / options.beta));
}

}  // namespace

Penalties::Penalties(const AggregationOptions& options, int jump_slack, int unit)
    : p1(Rounded(static_cast<double>(options.p1) / unit)),
      slack(jump_slack < 0 ? -1 : Rounded(static_cast<double>(jump_slack) / unit)) {
  for (std::size_t contrast = 0; contrast < p2.size(); ++contrast) {
    p2[contrast] = Rounded(LargeStep(options, static_cast<double>(contrast)) / unit);
  }
}

int CompactUnit(const AggregationOptions& options) {
  constexpr double kMost = 255.0;
  const double largest = kMost + LargeStep(options, 0.0);
  return static_cast<int>(std::ceil(largest / kMost));
}

}  // namespace stereo_sgmp
