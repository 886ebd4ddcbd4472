#include "refinement/subpixel.h"

#include "refinement/subpixel_kernel.h"

namespace stereo_sgmp {

void RefineSubpixelRows(const WinnerMap& map, Subpixel method, int begin, int end,
                        cv::Mat* disparity) {
  for (int y = begin; y < end; ++y) {
    const WinnerRow row{map.winner[y], map.cost[y], map.cost_below[y], map.cost_above[y],
                        map.shape.width};
    RefineSubpixelRow(row, method, static_cast<float>(map.shape.min_disparity),
                      disparity->ptr<float>(y));
  }
}

void RefineSubpixel(const WinnerMap& map, Subpixel method, cv::Mat* disparity, ThreadPool* pool) {
  disparity->create(map.winner.size(), CV_32F);
  pool->ForRanges(disparity->rows, [&](int begin, int end) {
    RefineSubpixelRows(map, method, begin, end, disparity);
  });
}

}  // namespace stereo_sgmp
