#include "prior/normals/surface_placement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "prior/coarse_scale.h"

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

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

// A scale (log of the mean d + doffs of a component) and what speaks for it, in coarse pixels.
struct Vote {
  double scale = 0.0;
  double weight = 0.0;
};

// Peaks of the density of the votes under a box of `half_width` pixels of d + doffs to both sides,
// the highest first, each without the votes of those before.
std::vector<Vote> Peaks(std::vector<Vote> votes, double half_width, double min_weight,
                        std::size_t most) {
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
      const double width = 2.0 * half_width * std::exp(-last->scale);
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

class Placement {
 public:
  Placement(const IntegratedNormals& normals, const CoarseDisparity& coarse, double doffs)
      : normals_(normals),
        ratio_(CoarseScale::Between(normals.component.size(), coarse.disparity.size())),
        half_width_(kTolerance * ratio_.x),
        doffs_(doffs),
        component_(coarse.disparity.size(), 0),
        vote_(coarse.disparity.size(), kUnknown) {
    LoadVotes(coarse);
    FindPeaks();
    FindScales();
  }

  void PlaceRow(int y, float* surface) const {
    int component = 0;
    int column = -1;
    double scale = kUnknown;
    const int row = CoarseIndex(y, ratio_.y, component_.rows);
    for (int x = 0; x < normals_.component.cols; ++x) {
      const int coarse_x = CoarseIndex(x, ratio_.x, component_.cols);
      if (normals_.component(y, x) != component || coarse_x != column) {
        component = normals_.component(y, x);
        column = coarse_x;
        scale = ScaleAt(component, {column, row});
      }
      surface[x] = static_cast<float>(std::exp(scale + normals_.log_disparity(y, x)) - doffs_);
    }
  }

 private:
  struct Component {
    std::vector<Vote> votes;
    double area = 0.0;  // coarse pixels
    std::vector<Vote> peaks;
    std::vector<Vote> scales;
  };

  static int CoarseIndex(int full, double ratio, int size) {
    return std::min(static_cast<int>((full + 0.5) / ratio), size - 1);
  }
  static int FullIndex(int coarse, double ratio, int size) {
    return std::min(static_cast<int>((coarse + 0.5) * ratio), size - 1);
  }

  void LoadVotes(const CoarseDisparity& coarse) {
    for (int y = 0; y < component_.rows; ++y) {
      const int full_y = FullIndex(y, ratio_.y, normals_.component.rows);
      for (int x = 0; x < component_.cols; ++x) {
        const int full_x = FullIndex(x, ratio_.x, normals_.component.cols);
        const int id = normals_.component(full_y, full_x);
        component_(y, x) = id;
        if (id == 0) continue;
        Component& component = components_[id];
        component.area += 1.0;
        const double disparity = coarse.disparity.at<float>(y, x) * ratio_.x + doffs_;
        if (coarse.confident.at<uchar>(y, x) == 0 || !(disparity > 0.0)) continue;
        const double scale = std::log(disparity) - normals_.log_disparity(full_y, full_x);
        vote_(y, x) = static_cast<float>(scale);
        component.votes.push_back({scale, 1.0});
      }
    }
  }

  void FindPeaks() {
    for (auto& [id, component] : components_) {
      const double least = std::max(kMinPeakPixels, kMinPeakShare * component.area);
      component.peaks = Peaks(std::move(component.votes), half_width_, least, kMaxPeaks);
    }
  }

  void FindScales() {
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
      component.scales = Peaks(std::move(pooled), half_width_, kMinScaleShare * area, kMaxScales);
    }
  }

  // The component and those that continue it, nearest first, with their offsets.
  std::vector<std::pair<int, double>> NearestOf(int id) const {
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

  // nan where the component has none.
  double ScaleAt(int id, cv::Point center) const {
    const auto found = components_.find(id);
    if (found == components_.end() || found->second.scales.empty()) return kUnknown;
    const std::vector<Vote>& scales = found->second.scales;
    if (scales.size() == 1) return scales.front().scale;
    const cv::Rect window(center.x - kChoiceRadius, center.y - kChoiceRadius, 2 * kChoiceRadius + 1,
                          2 * kChoiceRadius + 1);
    const cv::Rect inside = window & cv::Rect(cv::Point(), component_.size());
    double best = scales.front().scale;
    int most = 0;
    for (const Vote& scale : scales) {
      const int agreeing = CountAgreeing(id, scale.scale, inside);
      if (agreeing <= most) continue;
      most = agreeing;
      best = scale.scale;
    }
    return best;
  }

  int CountAgreeing(int id, double scale, const cv::Rect& window) const {
    const double half_width = half_width_ * std::exp(-scale);
    int count = 0;
    for (int y = window.y; y < window.br().y; ++y) {
      for (int x = window.x; x < window.br().x; ++x) {
        // False too where there is no vote.
        if (component_(y, x) == id && std::abs(vote_(y, x) - scale) <= half_width) ++count;
      }
    }
    return count;
  }

  const IntegratedNormals& normals_;
  CoarseScale ratio_;
  double half_width_;
  double doffs_;
  cv::Mat_<int> component_;  // at the middles of the coarse pixels
  cv::Mat_<float> vote_;     // nan where there is none
  std::unordered_map<int, Component> components_;
};

}  // namespace

cv::Mat_<float> PlaceSurfaces(const IntegratedNormals& normals, const CoarseDisparity& coarse,
                              double doffs, ThreadPool* pool) {
  const Placement placement(normals, coarse, doffs);
  cv::Mat_<float> surface(normals.component.size());
  pool->ForRanges(surface.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) placement.PlaceRow(y, surface[y]);
  });
  return surface;
}

}  // namespace stereo_sgmp
