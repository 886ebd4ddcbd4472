#include "refinement/validity.h"

#include <cstdint>

#include "refinement/validity_kernel.h"
#include "stereo_sgmp/match_result.h"

namespace stereo_sgmp {
namespace {

// As OpenCV's StereoSGBM asks for; the last of the reasons.
void FindAmbiguousInRow(const WinnerMap& map, double uniqueness_ratio, int y, std::uint8_t* out) {
  const std::uint16_t* const cost = map.cost[y];
  const std::uint16_t* const second = map.second[y];
  for (int x = 0; x < map.shape.width; ++x) {
    const bool ambiguous =
        second[x] != WinnerMap::kNone && second[x] * (100.0 - uniqueness_ratio) < cost[x] * 100.0;
    if (ambiguous && out[x] == static_cast<std::uint8_t>(InvalidReason::kValid)) {
      out[x] = static_cast<std::uint8_t>(InvalidReason::kUniqueness);
    }
  }
}

}  // namespace

void FindInvalid(const WinnerMap& map, const cv::Mat& left_right, const cv::Mat& disparity,
                 const cv::Mat& confidence, const FilterOptions& options, int begin, int end,
                 cv::Mat* reason) {
  for (int y = begin; y < end; ++y) {
    const CheckedRow row{left_right.ptr<std::uint16_t>(y), disparity.ptr<float>(y),
                         confidence.ptr<float>(y)};
    std::uint8_t* const out = reason->ptr(y);
    FindInvalidRow(map, y, row, options, out);
    if (options.uniqueness_ratio > 0.0) FindAmbiguousInRow(map, options.uniqueness_ratio, y, out);
  }
}

}  // namespace stereo_sgmp
