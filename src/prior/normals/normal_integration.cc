#include "prior/normals/normal_integration.h"

#include <atomic>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "prior/normals/cell_integrator.h"

namespace stereo_sgmp {
namespace {

// Side of the cells, pixels. Cells keep the systems small and errors local, but a surface has no
// jump from one to the next. Between 32 and 256 the share of wrong disparities of SGM-GNv changed
// by less than a tenth, up and down; from 128 on the time grew fast where normals contradict each
// other.
constexpr int kCellSize = 64;

std::string Describe(const cv::Mat& map) {
  return std::to_string(map.cols) + "x" + std::to_string(map.rows) + " of OpenCV type " +
         std::to_string(map.type());
}

void CheckMaps(const cv::Mat& normals, const cv::Mat& discontinuities) {
  if (normals.empty() || normals.type() != CV_32FC3) {
    throw std::invalid_argument("The normal map is " + Describe(normals) +
                                "; expected CV_32FC3, a vector (x, y, z) at each pixel.");
  }
  if (discontinuities.empty()) return;
  if (discontinuities.type() != CV_8UC1 || discontinuities.size() != normals.size()) {
    throw std::invalid_argument("The map of discontinuities is " + Describe(discontinuities) +
                                "; expected CV_8UC1 of the normal map's size, " +
                                std::to_string(normals.cols) + "x" + std::to_string(normals.rows) +
                                ".");
  }
}

// The `index`-th of `parts` nearly equal parts of [0, size) begins here.
int PartBegin(int size, int index, int parts) {
  return static_cast<int>(std::int64_t{size} * index / parts);
}

}  // namespace

IntegratedNormals IntegrateNormals(const cv::Mat& normals, const cv::Mat& discontinuities,
                                   const StereoCamera& camera, ThreadPool* pool) {
  CheckMaps(normals, discontinuities);
  camera.Check();
  IntegratedNormals result;
  result.log_disparity = cv::Mat_<float>::zeros(normals.size());
  result.component = cv::Mat_<int>::zeros(normals.size());
  const int columns = (normals.cols + kCellSize - 1) / kCellSize;
  const int rows = (normals.rows + kCellSize - 1) / kCellSize;
  std::atomic<int> next{0};
  pool->Run([&](int) {
    CellIntegrator integrator(normals, discontinuities, camera);
    for (int cell = next++; cell < columns * rows; cell = next++) {
      const int column = cell % columns;
      const int row = cell / columns;
      const cv::Point begin(PartBegin(normals.cols, column, columns),
                            PartBegin(normals.rows, row, rows));
      const cv::Point end(PartBegin(normals.cols, column + 1, columns),
                          PartBegin(normals.rows, row + 1, rows));
      integrator.Integrate(cv::Rect(begin, end), &result);
    }
  });
  if (cv::countNonZero(result.component) == 0) {
    throw std::invalid_argument(
        "The normal map shows no surface: all normals are zero, not finite or at right angles to "
        "the line of sight; expected unit normals in the camera's frame.");
  }
  return result;
}

}  // namespace stereo_sgmp
