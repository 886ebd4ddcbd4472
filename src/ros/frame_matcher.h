#ifndef STEREO_SGMP_ROS_FRAME_MATCHER_H_
#define STEREO_SGMP_ROS_FRAME_MATCHER_H_

#include <array>
#include <cstddef>
#include <memory>
#include <string>

#include <opencv2/core.hpp>

#include "matcher/load_governor.h"
#include "matcher/load_level.h"
#include "matcher/scaled_matcher.h"
#include "ros/stream_options.h"
#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// Matches the frames of a stream: with the range that was asked for in metres, at the load level
// that keeps the rate, and once more without prior for who wants to compare. Of one thread.
class FrameMatcher {
 public:
  explicit FrameMatcher(const NodeletOptions& options)
      : options_(options), match_options_(options.match), matcher_(options.match) {}

  // Takes effect with the next Match.
  void SetOptions(const NodeletOptions& options) { options_ = options; }

  // Throws as Matcher::Match.
  void Match(const cv::Mat& left, const cv::Mat& right, const StereoCamera& camera);

  // The frame of the last Match again, without prior. The same throws.
  void MatchBaseline(const cv::Mat& left, const cv::Mat& right);

  // Frees what MatchBaseline holds.
  void ReleaseBaseline() { baseline_.reset(); }

  // The result of the last Match stays as it is during the next one, which takes the memory of the
  // one before.
  void KeepResult() { keep_result_ = true; }

  // After all work for a frame, in seconds: decides the level of the next one.
  void NoteFrameTime(double seconds);

  const NodeletOptions& options() const { return options_; }

  // Of the last Match: the options of the matcher for the images as they came, and a sentence where
  // the range could not be searched as asked for.
  const Options& match_options() const { return match_options_; }
  const std::string& range_problem() const { return range_problem_; }
  const MatchResult& result() const { return results_[newest_]; }
  const LoadLevel& level() const { return *level_; }
  int level_index() const { return level_index_; }

  // Of the last MatchBaseline.
  const Options& baseline_options() const { return baseline_->options; }
  const MatchResult& baseline_result() const { return baseline_->result; }

 private:
  struct Baseline {
    explicit Baseline(const Options& match_options)
        : options(match_options), matcher(match_options) {}
    Options options;
    ScaledMatcher matcher;
    MatchResult result;
  };

  NodeletOptions options_;
  Options match_options_;
  std::string range_problem_;
  LoadGovernor governor_;
  int level_index_ = 0;
  const LoadLevel* level_ = &LoadLevels().front();
  ScaledMatcher matcher_;
  std::array<MatchResult, 2> results_;
  std::size_t newest_ = 0;
  bool keep_result_ = false;
  std::unique_ptr<Baseline> baseline_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_FRAME_MATCHER_H_
