#include "prior/label_spread.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include <hwy/base.h>

#include "images/pixel_difference_kernel.h"

namespace stereo_sgmp {
namespace {

constexpr int kReach = 150;

// Of each step, beside the difference of its pixels.
constexpr std::uint8_t kStepCost = 2;

constexpr std::uint8_t kUnreached = 255;
static_assert(kReach < kUnreached, "told apart from costs");

constexpr std::size_t kWord = sizeof(std::uint64_t);

std::uint64_t LoadWord(const std::uint8_t* bytes) {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes, kWord);
  return word;
}

}  // namespace

void LabelSpreader::Spread(const cv::Mat& image, cv::Mat* labels) {
  if (image.depth() != CV_8U || labels->type() != CV_16SC1 || image.size() != labels->size()) {
    throw std::invalid_argument(
        "Labels spread over an 8-bit image of their size; pass CV_16S labels and that image.");
  }
  Load(image, *labels);
  Seed(labels->size());
  for (int cost = 0; cost <= kReach; ++cost) {
    // Steps cost something, so that nothing is added to the list that is being read.
    for (const std::int32_t arrival : arrivals_[static_cast<std::size_t>(cost)]) {
      if (cost_[static_cast<std::size_t>(arrival)] == cost) Leave(arrival, cost);
    }
  }
  for (int y = 0; y < labels->rows; ++y) {
    std::copy_n(labels_.begin() + Index(0, y), labels->cols, labels->ptr<std::int16_t>(y));
  }
}

// The margin has cost 0, so that no path enters it.
void LabelSpreader::Load(const cv::Mat& image, const cv::Mat& labels) {
  stride_ = labels.cols + 2;
  const auto padded = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(labels.rows + 2);
  cost_.assign(padded + kWord, 0);
  right_.resize(padded);
  down_.resize(padded);
  labels_.resize(padded);
  for (int y = 0; y < labels.rows; ++y) {
    const std::int16_t* row = labels.ptr<std::int16_t>(y);
    const auto begin = static_cast<std::size_t>(Index(0, y));
    std::copy_n(row, labels.cols, &labels_[begin]);
    for (int x = 0; x < labels.cols; ++x) {
      cost_[begin + static_cast<std::size_t>(x)] = row[x] < 0 ? kUnreached : 0;
    }
    const std::uint8_t* pixels = image.ptr(y);
    const int channels = image.channels();
    PixelDifferences(pixels, pixels + channels, channels, image.cols - 1, kStepCost,
                     &right_[begin]);
    if (y + 1 < image.rows) {
      PixelDifferences(pixels, image.ptr(y + 1), channels, image.cols, kStepCost, &down_[begin]);
    }
  }
}

// Paths begin at labelled pixels; those among others with a label have nowhere to go.
void LabelSpreader::Seed(cv::Size size) {
  arrivals_.resize(kReach + 1);
  for (std::vector<std::int32_t>& arrivals : arrivals_) arrivals.clear();
  std::vector<std::int32_t>& first = arrivals_.front();
  for (int y = 0; y < size.height; ++y) {
    const std::int32_t row = Index(0, y);
    for (int x = 0; x < size.width; x += static_cast<int>(kWord)) {
      const std::uint8_t* cost = &cost_[static_cast<std::size_t>(row + x)];
      const std::uint64_t around = LoadWord(cost - 1) | LoadWord(cost + 1) |
                                   LoadWord(cost - stride_) | LoadWord(cost + stride_);
      // Costs are 0 or all bits as yet.
      for (std::uint64_t seeds = around & ~LoadWord(cost); seeds != 0;) {
        const int byte = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(seeds)) / 8;
        if (x + byte >= size.width) break;
        first.push_back(row + x + byte);
        seeds &= ~(std::uint64_t{0xFF} << (8 * byte));
      }
    }
  }
}

void LabelSpreader::Leave(std::int32_t from, int cost) {
  const auto i = static_cast<std::size_t>(from);
  const std::int16_t label = labels_[i];
  Arrive(from + 1, cost + right_[i], label);
  Arrive(from - 1, cost + right_[i - 1], label);
  Arrive(from + stride_, cost + down_[i], label);
  Arrive(from - stride_, cost + down_[i - static_cast<std::size_t>(stride_)], label);
}

void LabelSpreader::Arrive(std::int32_t at, int cost, std::int16_t label) {
  const auto i = static_cast<std::size_t>(at);
  if (cost > kReach || cost >= cost_[i]) return;
  cost_[i] = static_cast<std::uint8_t>(cost);
  labels_[i] = label;
  arrivals_[static_cast<std::size_t>(cost)].push_back(at);
}

}  // namespace stereo_sgmp
