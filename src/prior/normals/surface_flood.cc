#include "prior/normals/surface_flood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace stereo_sgmp {
namespace {

// Keeps the labels of a component few where normals contradict each other.
constexpr std::size_t kMaxScales = 6;
constexpr std::size_t kLevels = 256;

const std::array<cv::Point, 4> kSteps{cv::Point(1, 0), cv::Point(-1, 0), cv::Point(0, 1),
                                      cv::Point(0, -1)};

// Whether there is a pixel without a label beside it.
bool CanBeLeft(const cv::Mat_<schar>& label, cv::Point from) {
  const cv::Rect image(cv::Point(), label.size());
  return std::any_of(kSteps.begin(), kSteps.end(), [&](const cv::Point& step) {
    return image.contains(from + step) && label(from + step) < 0;
  });
}

// Null where no surface goes on from the one component to the other.
const IntegratedNormals::Continuation* FindContinuation(const IntegratedNormals& normals, int from,
                                                        int to) {
  const auto found = std::lower_bound(
      normals.continuations.begin(), normals.continuations.end(), std::make_pair(from, to),
      [](const IntegratedNormals::Continuation& c, const std::pair<int, int>& ends) {
        return std::make_pair(c.from, c.to) < ends;
      });
  if (found == normals.continuations.end() || found->from != from || found->to != to) {
    return nullptr;
  }
  return &*found;
}

}  // namespace

cv::Mat_<uchar> ImageEdges(const cv::Mat& image) {
  cv::Mat change;
  cv::morphologyEx(image, change, cv::MORPH_GRADIENT, cv::Mat::ones(3, 3, CV_8U));
  std::vector<cv::Mat> channels;
  cv::split(change, channels);
  for (std::size_t i = 1; i < channels.size(); ++i) {
    cv::max(channels.front(), channels[i], channels.front());
  }
  return channels.front();
}

void SurfaceFlood::Spread(const cv::Mat_<uchar>& edges, cv::Mat_<schar>* label) {
  reached_.assign(kLevels, {});
  std::vector<cv::Point>& lowest = reached_.front();
  for (int y = 0; y < label->rows; ++y) {
    for (int x = 0; x < label->cols; ++x) {
      if ((*label)(y, x) >= 0 && CanBeLeft(*label, {x, y})) lowest.emplace_back(x, y);
    }
  }
  for (std::size_t level = 0; level < kLevels; ++level) {
    // Grows while it is read.
    for (std::size_t i = 0; i < reached_[level].size(); ++i) {
      Leave(reached_[level][i], level, edges, label);
    }
  }
}

void SurfaceFlood::Leave(cv::Point from, std::size_t level, const cv::Mat_<uchar>& edges,
                         cv::Mat_<schar>* label) {
  const cv::Rect image(cv::Point(), label->size());
  for (const cv::Point& step : kSteps) {
    const cv::Point next = from + step;
    if (!image.contains(next) || (*label)(next) >= 0) continue;
    const int found = LabelIn(normals_.component(next), normals_.component(from), (*label)(from));
    if (found < 0) continue;
    (*label)(next) = static_cast<schar>(found);
    reached_[std::max(level, std::size_t{edges(next)})].push_back(next);
  }
}

// The label in component `to` of what has `label` in component `from`; -1 if it doesn't go on.
int SurfaceFlood::LabelIn(int to, int from, int label) {
  if (to == from) return label;
  const IntegratedNormals::Continuation* continuation = FindContinuation(normals_, from, to);
  if (continuation == nullptr) return -1;
  const double scale = table_.at(from)[static_cast<std::size_t>(label)] + continuation->offset;
  std::vector<double>& known = table_[to];
  const auto nearest = std::min_element(known.begin(), known.end(), [scale](double a, double b) {
    return std::abs(a - scale) < std::abs(b - scale);
  });
  if (nearest != known.end() && std::abs(*nearest - scale) <= tolerance_ * std::exp(-scale)) {
    return static_cast<int>(nearest - known.begin());
  }
  // Without a disparity to be sure of far around, a component stays unplaced.
  if (known.empty() || known.size() >= kMaxScales) return -1;
  known.push_back(scale);
  return static_cast<int>(known.size()) - 1;
}

}  // namespace stereo_sgmp
