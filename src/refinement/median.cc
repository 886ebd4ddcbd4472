#include "refinement/median.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "refinement/median_kernel.h"

namespace stereo_sgmp {

void MedianOfRows(const cv::Mat& image, int begin, int end, AlignedBuffer<float>* scratch,
                  cv::Mat* filtered) {
  scratch->Resize(static_cast<std::size_t>(MedianScratch(image.cols)));
  for (int y = begin; y < end; ++y) {
    std::array<const float*, kMedianSide> rows;
    for (int i = 0; i < kMedianSide; ++i) {
      const int row = std::clamp(y + i - kMedianRadius, 0, image.rows - 1);
      rows[static_cast<std::size_t>(i)] = image.ptr<float>(row);
    }
    MedianRow(rows, image.cols, scratch->data(), filtered->ptr<float>(y));
  }
}

}  // namespace stereo_sgmp
