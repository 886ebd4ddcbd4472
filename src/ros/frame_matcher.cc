#include "ros/frame_matcher.h"

#include <cstddef>
#include <utility>

#include "ros/search_range.h"

namespace stereo_sgmp {

void FrameMatcher::Match(const cv::Mat& left, const cv::Mat& right, const StereoCamera& camera) {
  SearchRange range = ResolveSearchRange(options_, camera, left.cols);
  match_options_ = range.options;
  range_problem_ = range.problem;
  level_index_ = governor_.level();
  level_ = &LoadLevels()[static_cast<std::size_t>(level_index_)];
  MatchInputs inputs;
  inputs.camera = camera;
  if (std::exchange(keep_result_, false)) newest_ = 1 - newest_;
  matcher_.Match(left, right, inputs, match_options_, *level_, &results_[newest_]);
}

void FrameMatcher::MatchBaseline(const cv::Mat& left, const cv::Mat& right) {
  Options options = match_options_;
  options.prior.variant = Variant::kSgm;
  if (!baseline_) baseline_ = std::make_unique<Baseline>(options);
  baseline_->options = options;
  baseline_->matcher.Match(left, right, MatchInputs(), options, *level_, &baseline_->result);
}

void FrameMatcher::NoteFrameTime(double seconds) {
  const double rate = options_.stream.target_rate;
  governor_.Update(seconds, rate > 0.0 ? 1.0 / rate : 0.0);
}

}  // namespace stereo_sgmp
