#include "prior/label_spread.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace stereo_sgmp {
namespace {

constexpr int kStepCost = 2;
constexpr int kReach = 150;

int LargestDifference(const cv::Mat& image, int x1, int y1, int x2, int y2) {
  const int channels = image.channels();
  const std::uint8_t* a = image.ptr<std::uint8_t>(y1) + x1 * channels;
  const std::uint8_t* b = image.ptr<std::uint8_t>(y2) + x2 * channels;
  int largest = 0;
  for (int c = 0; c < std::min(channels, 3); ++c)
    largest = std::max(largest, std::abs(a[c] - b[c]));
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
      if (cost_(arrival.y, arrival.x) == cost) Leave(image, arrival, cost, labels);
    }
  }
}

void LabelSpreader::Seed(const cv::Mat& labels) {
  cost_.create(labels.size());
  cost_.setTo(std::numeric_limits<int>::max());
  arrivals_.resize(kReach + 1);
  for (std::vector<Arrival>& arrivals : arrivals_) arrivals.clear();
  for (int y = 0; y < labels.rows; ++y) {
    const std::int16_t* row = labels.ptr<std::int16_t>(y);
    for (int x = 0; x < labels.cols; ++x) {
      if (row[x] < 0) continue;
      cost_(y, x) = 0;
      arrivals_.front().push_back({x, y});
    }
  }
}

void LabelSpreader::Leave(const cv::Mat& image, Arrival from, int cost, cv::Mat* labels) {
  constexpr int kSteps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  for (const auto& [dx, dy] : kSteps) {
    const int x = from.x + dx;
    const int y = from.y + dy;
    if (x < 0 || y < 0 || x >= image.cols || y >= image.rows) continue;
    const int arrival = cost + kStepCost + LargestDifference(image, from.x, from.y, x, y);
    if (arrival > kReach || arrival >= cost_(y, x)) continue;
    cost_(y, x) = arrival;
    labels->at<std::int16_t>(y, x) = labels->at<std::int16_t>(from.y, from.x);
    arrivals_[static_cast<std::size_t>(arrival)].push_back({x, y});
  }
}

}  // namespace stereo_sgmp
