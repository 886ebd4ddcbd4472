#ifndef STEREO_SGMP_MATCHER_MEMORY_H_
#define STEREO_SGMP_MATCHER_MEMORY_H_

#include <cstddef>

#include <opencv2/core.hpp>

#include "cost/cost_rows.h"
#include "stereo_sgmp/match_inputs.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// Throws std::runtime_error, naming both sizes and what to change, when a Matcher that already
// holds `held` bytes would need more than the machine has left, or than Options::memory_limit even
// in the smallest strips.
void CheckMemory(const Options& options, cv::Size image_size, const MatchInputs& inputs,
                 std::size_t held);

// Rows of the volume `searched` that the aggregation holds at a time (RowStrips) for a Matcher to
// keep to Options::memory_limit; 0: all. As few as need the least memory where nothing keeps to it.
int StripRows(const Options& options, const VolumeShape& searched, const MatchInputs& inputs);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_MATCHER_MEMORY_H_
