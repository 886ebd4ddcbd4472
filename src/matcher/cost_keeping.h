#ifndef STEREO_SGMP_MATCHER_COST_KEEPING_H_
#define STEREO_SGMP_MATCHER_COST_KEEPING_H_

#include "cost/cost_rows.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// Whether the costs of a volume that are computed for one sweep are kept for the next (KeptCosts):
// where computing them again would take longer than bringing them back from memory.
bool KeepsCosts(const Options& options, const VolumeShape& shape);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_MATCHER_COST_KEEPING_H_
