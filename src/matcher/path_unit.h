#ifndef STEREO_SGMP_MATCHER_PATH_UNIT_H_
#define STEREO_SGMP_MATCHER_PATH_UNIT_H_

#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// The unit (CostRows::unit) to match in: the smallest with which path costs fit 8 bits, where
// compact costs are asked for and exist; else 1. `given_costs`: from a volume instead of images.
int PathUnit(const Options& options, bool given_costs);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_MATCHER_PATH_UNIT_H_
