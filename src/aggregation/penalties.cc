#include "aggregation/penalties.h"

#include <cmath>
#include <cstddef>

namespace stereo_sgmp {

Penalties::Penalties(const AggregationOptions& options)
    : p1(static_cast<std::uint16_t>(options.p1)) {
  for (std::size_t contrast = 0; contrast < p2.size(); ++contrast) {
    const double decay = std::exp(-static_cast<double>(contrast) / options.beta);
    p2[contrast] =
        static_cast<std::uint16_t>(std::lround(options.p1 * (1.0 + options.alpha * decay)));
  }
}

}  // namespace stereo_sgmp
