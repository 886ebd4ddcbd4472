#include "stereo_sgmp/match_result.h"

namespace stereo_sgmp {

void FilteredDisparity(const MatchResult& result, float invalid_value, cv::Mat* disparity) {
  result.dense.copyTo(*disparity);
  disparity->setTo(invalid_value, result.reason);
}

}  // namespace stereo_sgmp
