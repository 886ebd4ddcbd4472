#include "refinement/left_right.h"

#include <cstdint>
#include <cstdlib>

namespace stereo_sgmp {
namespace {

// Without branches, which random winners would mispredict.
void DifferencesOfRow(const WinnerMap& map, int y, std::uint16_t* out) {
  const std::uint16_t* winner = map.winner[y];
  const std::uint16_t* right_winner = map.right_winner[y];
  const auto width = static_cast<unsigned>(map.shape.width);
  for (int x = 0; x < map.shape.width; ++x) {
    const auto match = static_cast<unsigned>(x - map.shape.min_disparity - winner[x]);
    const bool inside = match < width;
    const std::uint16_t right = right_winner[inside ? match : 0];
    const auto difference = static_cast<std::uint16_t>(std::abs(right - winner[x]));
    out[x] = inside & (right != WinnerMap::kNone) ? difference : WinnerMap::kNone;
  }
}

}  // namespace

void LeftRightDifferences(const WinnerMap& map, cv::Mat* difference, ThreadPool* pool) {
  difference->create(map.winner.size(), CV_16U);
  pool->ForRanges(difference->rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) DifferencesOfRow(map, y, difference->ptr<std::uint16_t>(y));
  });
}

void LeftRightMask(const cv::Mat& difference, int worst, cv::Mat* mask, ThreadPool* pool) {
  mask->create(difference.size(), CV_8U);
  pool->ForRanges(mask->rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const std::uint16_t* row = difference.ptr<std::uint16_t>(y);
      std::uint8_t* out = mask->ptr(y);
      for (int x = 0; x < mask->cols; ++x) out[x] = row[x] < worst ? 255 : 0;
    }
  });
}

}  // namespace stereo_sgmp
