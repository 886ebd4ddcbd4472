#ifndef STEREO_SGMP_MATCHER_STAGE_CLOCK_H_
#define STEREO_SGMP_MATCHER_STAGE_CLOCK_H_

#include <chrono>
#include <cstddef>
#include <vector>

#include "stereo_sgmp/match_result.h"

namespace stereo_sgmp {

// Times the stages of a frame, one after the other.
class StageClock {
 public:
  // Starts a frame whose stages go to `statistics`.
  explicit StageClock(MatchStatistics* statistics) : statistics_(statistics) {}

  // The time since the last mark, or the start, was spent on `stage`.
  void Mark(const char* stage) {
    const auto now = Clock::now();
    if (count_ == statistics_->stages.size()) statistics_->stages.emplace_back();
    StageTime& time = statistics_->stages[count_++];
    time.name = stage;
    time.ms = Milliseconds(now - last_);
    last_ = now;
  }

  // Ends the frame.
  void Finish() {
    statistics_->stages.resize(count_);
    statistics_->frame_ms = Milliseconds(last_ - start_);
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double Milliseconds(Clock::duration duration) {
    return std::chrono::duration<double, std::milli>(duration).count();
  }

  MatchStatistics* statistics_;
  std::size_t count_ = 0;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_MATCHER_STAGE_CLOCK_H_
