#include "prior/normals/surface_placement.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "prior/normals/component_cuts.h"
#include "prior/normals/component_scales.h"
#include "prior/normals/surface_flood.h"

namespace stereo_sgmp {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

// The index of each pixel's scale in the table, or -1.
cv::Mat_<schar> ChooseScales(const IntegratedNormals& normals, const ComponentScales& scales,
                             const cv::Mat_<uchar>& edges, ScaleTable* table, ThreadPool* pool) {
  const cv::Size size = normals.component.size();
  cv::Mat_<schar> clear(size);
  cv::Mat_<schar> likely(size);
  pool->ForRanges(size.height, [&](int begin, int end) {
    std::vector<ComponentScales::Choice> row(static_cast<std::size_t>(size.width));
    for (int y = begin; y < end; ++y) {
      scales.ChooseRow(y, row.data());
      for (int x = 0; x < size.width; ++x) {
        const ComponentScales::Choice& choice = row[static_cast<std::size_t>(x)];
        likely(y, x) = static_cast<schar>(choice.index);
        clear(y, x) = static_cast<schar>(choice.clear ? choice.index : -1);
      }
    }
  });
  SurfaceFlood(normals, scales.tolerance(), table).Spread(edges, &clear);
  likely.copyTo(clear, clear < 0);
  return clear;
}

void PlaceRow(const IntegratedNormals& normals, const ScaleTable& table,
              const cv::Mat_<schar>& labels, double doffs, int y, float* disparity) {
  int component = 0;
  int label = -1;
  double scale = kUnknown;
  for (int x = 0; x < labels.cols; ++x) {
    if (normals.component(y, x) != component || labels(y, x) != label) {
      component = normals.component(y, x);
      label = labels(y, x);
      scale = label < 0 ? kUnknown : table.at(component)[static_cast<std::size_t>(label)];
    }
    disparity[x] = static_cast<float>(std::exp(scale + normals.log_disparity(y, x)) - doffs);
  }
}

}  // namespace

PlacedSurfaces PlaceSurfaces(const IntegratedNormals& normals, const CoarseDisparity& coarse,
                             const cv::Mat& image, double doffs, ThreadPool* pool) {
  const ComponentScales scales(normals, coarse, doffs);
  ScaleTable table = scales.table();
  const cv::Mat_<uchar> edges = ImageEdges(image);
  const cv::Mat_<schar> label = ChooseScales(normals, scales, edges, &table, pool);
  PlacedSurfaces placed;
  placed.component = CutComponents(normals.component, label, edges);
  placed.disparity.create(label.size());
  pool->ForRanges(label.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      PlaceRow(normals, table, label, doffs, y, placed.disparity[y]);
    }
  });
  return placed;
}

}  // namespace stereo_sgmp
