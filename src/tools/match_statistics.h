#ifndef STEREO_SGMP_TOOLS_MATCH_STATISTICS_H_
#define STEREO_SGMP_TOOLS_MATCH_STATISTICS_H_

#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// Times and counts of one pair matched once or several times, as JSON: frame_ms and stages_ms are
// medians, of all frames but the first where there are several; the counts are the last frame's,
// and so is `priors`.
std::string StatisticsJson(const std::vector<MatchStatistics>& frames, const PlanePriors& priors,
                           const Options& options, cv::Size image_size);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_TOOLS_MATCH_STATISTICS_H_
