#ifndef STEREO_SGMP_MATCHER_SCALED_MATCHER_H_
#define STEREO_SGMP_MATCHER_SCALED_MATCHER_H_

#include <opencv2/core.hpp>

#include "matcher/load_level.h"
#include "stereo_sgmp/match_inputs.h"
#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/matcher.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// A Matcher that matches smaller images where a load level asks for it. Its results are always of
// the size and in the pixels of the images given, so that nobody downstream has to know.
class ScaledMatcher {
 public:
  // Throws as Matcher's constructor.
  explicit ScaledMatcher(const Options& options) : matcher_(options) {}

  // Throws as Matcher::SetOptions and Matcher::Match. Of `inputs`, only the camera is scaled:
  // there must be no maps in it.
  void Match(const cv::Mat& left, const cv::Mat& right, const MatchInputs& inputs,
             const Options& options, const LoadLevel& level, MatchResult* result);

 private:
  Matcher matcher_;
  cv::Mat left_;
  cv::Mat right_;
  MatchResult small_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_MATCHER_SCALED_MATCHER_H_
