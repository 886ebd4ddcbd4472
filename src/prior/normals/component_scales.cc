#include "prior/normals/component_scales.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace stereo_sgmp {
namespace {

// Coarse pixels by which disparities that agree may differ from their surface.
constexpr double kTolerance = 0.75;
// Peaks of the disparities of a component that its neighbours hear of: by pixels and by share.
constexpr std::size_t kMaxPeaks = 4;
constexpr double kMinPeakPixels = 4.0;
constexpr double kMinPeakShare = 0.05;
// Components whose disparities are taken together. Where normals are exact more of them reach
// further along thin things; fewer keep surfaces apart that lie one behind the other.
constexpr std::size_t kPool = 15;
// Scales of a component; of the pixels taken together each has this share.
constexpr std::size_t kMaxScales = 3;
constexpr double kMinScaleShare = 0.15;
// Half the side of the window, in coarse pixels, in which a pixel chooses among scales.
constexpr int kChoiceRadius = 2;
// The choice is clear where so much of what the window shows of the component agrees with it, and
// nothing with another scale: beside a step coarse disparities are off by a pixel or two.
constexpr double kClearShare = 0.8;

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

int CoarseIndex(int full, double ratio, int size) {
  return std::min(static_cast<int>((full + 0.5) / ratio), size - 1);
}
int FullIndex(int coarse, double ratio, int size) {
  return std::min(static_cast<int>((coarse + 0.5) * ratio), size - 1);
}

}  // namespace

ComponentScales::ComponentScales(const IntegratedNormals& normals, const CoarseDisparity& coarse,
                                 double doffs)
    : normals_(normals),
      ratio_(CoarseScale::Between(normals.component.size(), coarse.disparity.size())),
      tolerance_(kTolerance * ratio_.x),
      component_(coarse.disparity.size(), 0),
      vote_(coarse.disparity.size(), kUnknown) {
  LoadVotes(coarse, doffs);
  FindPeaks();
  FindScales();
}

void ComponentScales::ChooseRow(int y, Choice* row) const {
  const int coarse_y = CoarseIndex(y, ratio_.y, component_.rows);
  int component = 0;
  int column = -1;
  Choice choice;
  for (int x = 0; x < normals_.component.cols; ++x) {
    const int coarse_x = CoarseIndex(x, ratio_.x, component_.cols);
    if (normals_.component(y, x) != component || coarse_x != column) {
      component = normals_.component(y, x);
      column = coarse_x;
      choice = ChooseAt(component, {column, coarse_y});
    }
    row[x] = choice;
  }
}

// Peaks of the density of the votes under a box of `tolerance` pixels of d + doffs to both sides,
// the highest first, each without the votes of those before.
std::vector<ComponentScales::Vote> ComponentScales::Peaks(std::vector<Vote> votes, double tolerance,
                                                          double min_weight, std::size_t most) {
  std::sort(votes.begin(), votes.end(), [](const Vote& a, const Vote& b) {
    return a.scale < b.scale || (a.scale == b.scale && a.weight < b.weight);
  });
  std::vector<Vote> peaks;
  while (peaks.size() < most) {
    double weight = 0.0;
    double fullest = 0.0;
    auto begin = votes.begin();
    auto end = votes.begin();
    for (auto first = votes.begin(), last = votes.begin(); last != votes.end(); ++last) {
      weight += last->weight;
      const double width = 2.0 * tolerance * std::exp(-last->scale);
      while (last->scale - first->scale > width) weight -= (first++)->weight;
      if (weight <= fullest) continue;
      fullest = weight;
      begin = first;
      end = last + 1;
    }
    if (fullest == 0.0 || fullest < min_weight) break;
    double sum = 0.0;
    for (auto vote = begin; vote != end; ++vote) sum += vote->weight * vote->scale;
    peaks.push_back({sum / fullest, fullest});
    votes.erase(begin, end);
  }
  return peaks;
}

void ComponentScales::LoadVotes(const CoarseDisparity& coarse, double doffs) {
  for (int y = 0; y < component_.rows; ++y) {
    const int full_y = FullIndex(y, ratio_.y, normals_.component.rows);
    for (int x = 0; x < component_.cols; ++x) {
      const int full_x = FullIndex(x, ratio_.x, normals_.component.cols);
      const int id = normals_.component(full_y, full_x);
      component_(y, x) = id;
      if (id == 0) continue;
      Component& component = components_[id];
      component.area += 1.0;
      const double disparity = coarse.disparity.at<float>(y, x) * ratio_.x + doffs;
      if (coarse.confident.at<uchar>(y, x) == 0 || !(disparity > 0.0)) continue;
      const double scale = std::log(disparity) - normals_.log_disparity(full_y, full_x);
      vote_(y, x) = static_cast<float>(scale);
      component.votes.push_back({scale, 1.0});
    }
  }
}

void ComponentScales::FindPeaks() {
  for (auto& [id, component] : components_) {
    const double least = std::max(kMinPeakPixels, kMinPeakShare * component.area);
    component.peaks = Peaks(std::move(component.votes), tolerance_, least, kMaxPeaks);
  }
}

void ComponentScales::FindScales() {
  for (auto& [id, component] : components_) {
    std::vector<Vote> pooled;
    double area = 0.0;
    for (const auto& [near, offset] : NearestOf(id)) {
      const auto found = components_.find(near);
      if (found == components_.end()) continue;
      area += found->second.area;
      for (const Vote& peak : found->second.peaks) {
        pooled.push_back({peak.scale - offset, peak.weight});
      }
    }
    for (const Vote& scale :
         Peaks(std::move(pooled), tolerance_, kMinScaleShare * area, kMaxScales)) {
      table_[id].push_back(scale.scale);
    }
  }
}

// The component and those that continue it, nearest first, with their offsets.
std::vector<std::pair<int, double>> ComponentScales::NearestOf(int id) const {
  std::vector<std::pair<int, double>> reached{{id, 0.0}};
  const auto is_reached = [&reached](int other) {
    return std::any_of(reached.begin(), reached.end(),
                       [other](const auto& entry) { return entry.first == other; });
  };
  for (std::size_t i = 0; i < reached.size() && reached.size() < kPool; ++i) {
    const auto [from, offset] = reached[i];
    auto next = std::lower_bound(
        normals_.continuations.begin(), normals_.continuations.end(), from,
        [](const IntegratedNormals::Continuation& c, int value) { return c.from < value; });
    for (; next != normals_.continuations.end() && next->from == from; ++next) {
      if (!is_reached(next->to)) reached.emplace_back(next->to, offset + next->offset);
    }
  }
  return reached;
}

ComponentScales::Choice ComponentScales::ChooseAt(int id, cv::Point center) const {
  const auto found = table_.find(id);
  if (found == table_.end()) return {};
  const cv::Rect window(center.x - kChoiceRadius, center.y - kChoiceRadius, 2 * kChoiceRadius + 1,
                        2 * kChoiceRadius + 1);
  const cv::Rect inside = window & cv::Rect(cv::Point(), component_.size());
  Choice choice{0, false};
  int most = 0;
  int all = 0;
  for (std::size_t i = 0; i < found->second.size(); ++i) {
    const int agreeing = CountAgreeing(id, found->second[i], inside);
    all += agreeing;
    if (agreeing <= most) continue;
    most = agreeing;
    choice.index = static_cast<int>(i);
  }
  choice.clear = most > 0 && most == all && most >= kClearShare * CountArea(id, inside);
  return choice;
}

int ComponentScales::CountAgreeing(int id, double scale, const cv::Rect& window) const {
  const double width = tolerance_ * std::exp(-scale);
  int count = 0;
  for (int y = window.y; y < window.br().y; ++y) {
    for (int x = window.x; x < window.br().x; ++x) {
      // False too where there is no vote.
      if (component_(y, x) == id && std::abs(vote_(y, x) - scale) <= width) ++count;
    }
  }
  return count;
}

int ComponentScales::CountArea(int id, const cv::Rect& window) const {
  int count = 0;
  for (int y = window.y; y < window.br().y; ++y) {
    const int* row = component_[y];
    count += static_cast<int>(std::count(row + window.x, row + window.br().x, id));
  }
  return count;
}

}  // namespace stereo_sgmp
