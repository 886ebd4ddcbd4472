#include "cost/cost_unit.h"

#include <sstream>
#include <stdexcept>

namespace stereo_sgmp {

void CheckCostUnit(int unit) {
  if (unit >= 1 && unit <= kMaxCostUnit) return;
  std::ostringstream message;
  message << "The unit of the matching cost is " << unit << ", expected 1 (full costs) to "
          << kMaxCostUnit << "; use one of these.";
  throw std::invalid_argument(message.str());
}

}  // namespace stereo_sgmp
