#include "refinement/left_right.h"

#include <cstdint>

#include "refinement/left_right_kernel.h"

namespace stereo_sgmp {

void LeftRightDifferences(const WinnerMap& map, int begin, int end, cv::Mat* difference) {
  for (int y = begin; y < end; ++y) {
    LeftRightDifferencesRow(map, y, difference->ptr<std::uint16_t>(y));
  }
}

void LeftRightMask(const cv::Mat& difference, int worst, int begin, int end, cv::Mat* mask) {
  const int width = difference.cols;
  for (int y = begin; y < end; ++y) {
    const std::uint16_t* const row = difference.ptr<std::uint16_t>(y);
    std::uint8_t* const out = mask->ptr(y);
    for (int x = 0; x < width; ++x) out[x] = row[x] < worst ? 255 : 0;
  }
}

}  // namespace stereo_sgmp
