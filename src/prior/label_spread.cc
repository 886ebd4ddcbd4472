#include "prior/label_spread.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>

namespace stereo_sgmp {
namespace {

constexpr int kStepCost = 2;
constexpr int kReach = 150;

constexpr std::uint8_t kUnreached = 255;
static_assert(kReach < kUnreached, "told apart from costs");

int LargestDifference(const std::uint8_t* a, const std::uint8_t* b, int channels) {
  int largest = 0;
  for (int c = 0; c < channels; ++c) largest = std::max(largest, std::abs(a[c] - b[c]));
  return largest;
}

}  // namespace

void LabelSpreader::Spread(const cv::Mat& image, cv::Mat* labels) {
  if (image.depth() != CV_8U || labels->type() != CV_16SC1 || image.size() != labels->size()) {
    throw std::invalid_argument(
        "Labels spread over an 8-bit image of their size; pass CV_16S labels and that image.");
  }
  Seed(*labels);
  for (int cost = 0; cost <= kReach; ++cost) {
    const std::vector<Arrival>& here = arrivals_[static_cast<std::size_t>(cost)];
    // Steps cost something, so that nothing is added to the list that is being read.
    for (const Arrival& arrival : here) {
      if (cost_[CostIndex(arrival.x, arrival.y)] == cost) Leave(image, arrival, cost, labels);
    }
  }
}

std::size_t LabelSpreader::CostIndex(int x, int y) const {
  return static_cast<std::size_t>(y + 1) * stride_ + static_cast<std::size_t>(x + 1);
}

// The margin has cost 0, so that no path enters it.
void LabelSpreader::Seed(const cv::Mat& labels) {
  stride_ = static_cast<std::size_t>(labels.cols) + 2;
  cost_.assign(stride_ * (static_cast<std::size_t>(labels.rows) + 2), 0);
  for (int y = 0; y < labels.rows; ++y) {
    const std::int16_t* row = labels.ptr<std::int16_t>(y);
    std::uint8_t* cost = cost_.data() + CostIndex(0, y);
    for (int x = 0; x < labels.cols; ++x) cost[x] = row[x] < 0 ? kUnreached : 0;
  }
  arrivals_.resize(kReach + 1);
  for (std::vector<Arrival>& arrivals : arrivals_) arrivals.clear();
  for (int y = 0; y < labels.rows; ++y) {
    const std::uint8_t* cost = cost_.data() + CostIndex(0, y);
    for (int x = 0; x < labels.cols; ++x) {
      // Those among others with a label have nowhere to go.
      const int around = cost[x - 1] | cost[x + 1] | *(cost + x - stride_) | cost[x + stride_];
      if (cost[x] == 0 && around != 0) arrivals_.front().push_back({x, y});
    }
  }
}

void LabelSpreader::Leave(const cv::Mat& image, Arrival from, int cost, cv::Mat* labels) {
  constexpr int kSteps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  const int channels = image.channels();
  const std::uint8_t* const pixel = image.ptr<std::uint8_t>(from.y) + from.x * channels;
  const std::int16_t label = labels->at<std::int16_t>(from.y, from.x);
  for (const auto& [dx, dy] : kSteps) {
    const int x = from.x + dx;
    const int y = from.y + dy;
    std::uint8_t& best = cost_[CostIndex(x, y)];
    if (best <= cost + kStepCost) continue;
    const std::uint8_t* const next = image.ptr<std::uint8_t>(y) + x * channels;
    const int arrival = cost + kStepCost + LargestDifference(pixel, next, std::min(channels, 3));
    if (arrival > kReach || arrival >= best) continue;
    best = static_cast<std::uint8_t>(arrival);
    labels->at<std::int16_t>(y, x) = label;
    arrivals_[static_cast<std::size_t>(arrival)].push_back({x, y});
  }
}

}  // namespace stereo_sgmp
