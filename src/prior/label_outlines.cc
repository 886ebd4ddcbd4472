#include "prior/label_outlines.h"

#include <cstdint>

namespace stereo_sgmp {

void CollectLabelOutlines(const cv::Mat& labels, std::size_t count,
                          std::vector<std::vector<cv::Point>>* outlines) {
  if (outlines->size() < count) outlines->resize(count);
  for (std::vector<cv::Point>& outline : *outlines) outline.clear();
  for (int y = 0; y < labels.rows; ++y) {
    const std::int16_t* row = labels.ptr<std::int16_t>(y);
    for (int x = 0; x < labels.cols; ++x) {
      if (row[x] < 0) continue;
      std::vector<cv::Point>& outline = (*outlines)[static_cast<std::size_t>(row[x])];
      const std::size_t n = outline.size();
      const bool extends_row = n >= 2 && outline[n - 1].y == y && outline[n - 2].y == y;
      if (extends_row) {
        outline.back().x = x;
      } else {
        outline.emplace_back(x, y);
      }
    }
  }
}

}  // namespace stereo_sgmp
