#include "matcher/load_governor.h"

#include <algorithm>
#include <cstddef>

#include "matcher/load_level.h"

namespace stereo_sgmp {
namespace {

// In budgets. A frame that waits for longer than one is lost to the next. A single late frame
// lowers nothing.
constexpr double kMostBehind = 1.0;
constexpr double kMostAdded = 0.6;
constexpr double kMargin = 0.9;  // share of the budget that a raise may be expected to take
constexpr int kGrowth = 8;       // of the patience with a level that has proved too slow
constexpr double kWeightOfNewest = 0.125;
constexpr int kTrial = 60;  // frames after which a raise has proved right

}  // namespace

void LoadGovernor::Update(double time, double budget) {
  if (budget <= 0.0) {
    *this = LoadGovernor();
    return;
  }
  const double share = time / budget;
  ++frames_;
  mean_ += (frames_ == 1 ? 1.0 : kWeightOfNewest) * (share - mean_);
  behind_ = std::max(0.0, behind_ + std::min(share - 1.0, kMostAdded));
  if (behind_ >= kMostBehind) return Lower();
  if (on_trial_ && frames_ > kTrial) {
    on_trial_ = false;
    if (level_ <= too_slow_) too_slow_ = -1;
  }
  const double ratio = LoadLevels()[static_cast<std::size_t>(level_)].cost_of_previous;
  if (level_ > 0 && frames_ >= Patience() && mean_ * ratio < kMargin) Raise();
}

int LoadGovernor::Patience() const { return level_ - 1 > too_slow_ ? kFirstPatience : patience_; }

void LoadGovernor::Lower() {
  if (on_trial_) {
    const int before = level_ == too_slow_ ? patience_ : kFirstPatience;
    patience_ = std::min(kGrowth * before, kLastPatience);
    too_slow_ = level_;
  }
  on_trial_ = false;
  GoTo(std::min(level_ + 1, static_cast<int>(LoadLevels().size()) - 1));
}

void LoadGovernor::Raise() {
  on_trial_ = true;
  GoTo(level_ - 1);
}

void LoadGovernor::GoTo(int level) {
  level_ = level;
  frames_ = 0;
  behind_ = 0.0;
}

}  // namespace stereo_sgmp
