#include "matcher/load_governor.h"

#include <algorithm>
#include <cstddef>

#include "matcher/load_level.h"

namespace stereo_sgmp {
namespace {

constexpr int kLateFrames = 2;
constexpr double kMargin = 0.9;  // share of the budget that a raise may be expected to take

}  // namespace

void LoadGovernor::Update(double time, double budget) {
  if (budget <= 0.0) {
    *this = LoadGovernor();
    return;
  }
  ++since_raise_;
  if (since_raise_ > 2 * patience_) patience_ = std::max(kFirstPatience, patience_ / 2);
  late_ = time > budget ? late_ + 1 : 0;
  if (late_ >= kLateFrames) return Lower();
  const double ratio = LoadLevels()[static_cast<std::size_t>(level_)].cost_of_previous;
  early_ = level_ > 0 && time * ratio < kMargin * budget ? early_ + 1 : 0;
  if (early_ >= patience_) Raise();
}

void LoadGovernor::Lower() {
  late_ = early_ = 0;
  if (level_ + 1 == static_cast<int>(LoadLevels().size())) return;
  const bool raise_failed = since_raise_ <= patience_;
  if (raise_failed) patience_ = std::min(2 * patience_, kLastPatience);
  ++level_;
}

void LoadGovernor::Raise() {
  late_ = early_ = since_raise_ = 0;
  --level_;
}

}  // namespace stereo_sgmp
