#include "prior/normals/normal_integration.h"

#include <atomic>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "prior/normals/cell_integrator.h"
#include "prior/normals/normal_field.h"

namespace stereo_sgmp {
namespace {

// Cells keep the systems small and errors local, but a surface has no jump from one to the next.
// Between 32 and 256 pixels the share of wrong disparities of SGM-GNv changed by less than a tenth,
// up and down; from 128 on the time grew fast where normals contradict each other.
constexpr int kCellSize = IntegratedNormals::kCellSize;

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

// Nearly equal cells, row by row.
class CellGrid {
 public:
  explicit CellGrid(cv::Size size)
      : size_(size),
        columns_((size.width + kCellSize - 1) / kCellSize),
        rows_((size.height + kCellSize - 1) / kCellSize) {}

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int count() const { return columns_ * rows_; }
  int Left(int column) const { return PartBegin(size_.width, column, columns_); }
  int Top(int row) const { return PartBegin(size_.height, row, rows_); }
  cv::Rect Cell(int index) const {
    const int column = index % columns_;
    const int row = index / columns_;
    return {cv::Point(Left(column), Top(row)), cv::Point(Left(column + 1), Top(row + 1))};
  }

 private:
  static int PartBegin(int size, int index, int parts) {
    return static_cast<int>(std::int64_t{size} * index / parts);
  }

  cv::Size size_;
  int columns_;
  int rows_;
};

// Finds the surfaces that go on across the borders of cells.
class Continuer {
 public:
  Continuer(const NormalField& field, IntegratedNormals* result)
      : field_(field), result_(*result) {}

  void Find(const CellGrid& grid) {
    for (int column = 1; column < grid.columns(); ++column) {
      const int x = grid.Left(column);
      for (int y = 0; y < result_.component.rows; ++y) Cross({x - 1, y}, {x, y});
    }
    for (int row = 1; row < grid.rows(); ++row) {
      const int y = grid.Top(row);
      for (int x = 0; x < result_.component.cols; ++x) Cross({x, y - 1}, {x, y});
    }
    result_.continuations.clear();
    for (const auto& [ends, mean] : found_) {
      result_.continuations.push_back({ends.first, ends.second, mean.sum / mean.weight});
    }
  }

 private:
  struct Mean {
    double sum = 0.0;
    double weight = 0.0;
  };

  void Cross(cv::Point p, cv::Point q) {
    const int from = result_.component(p);
    const int to = result_.component(q);
    if (from == 0 || to == 0) return;
    const NormalField::Step step = NormalField::Between(field_.At(p.x, p.y), field_.At(q.x, q.y));
    if (step.weight == 0.0) return;
    const double offset = result_.log_disparity(p) + step.delta - result_.log_disparity(q);
    Add({from, to}, offset, step.weight);
    Add({to, from}, -offset, step.weight);
  }

  void Add(std::pair<int, int> ends, double offset, double weight) {
    Mean& mean = found_[ends];
    mean.sum += weight * offset;
    mean.weight += weight;
  }

  const NormalField& field_;
  IntegratedNormals& result_;
  std::map<std::pair<int, int>, Mean> found_;
};

}  // namespace

IntegratedNormals IntegrateNormals(const cv::Mat& normals, const cv::Mat& discontinuities,
                                   const StereoCamera& camera, ThreadPool* pool) {
  CheckMaps(normals, discontinuities);
  camera.Check();
  IntegratedNormals result;
  result.log_disparity = cv::Mat_<float>::zeros(normals.size());
  result.component = cv::Mat_<int>::zeros(normals.size());
  const CellGrid grid(normals.size());
  const NormalField field(normals, discontinuities, camera);
  std::atomic<int> next{0};
  pool->Share([&](int) {
    CellIntegrator integrator(field);
    for (int cell = next++; cell < grid.count(); cell = next++) {
      integrator.Integrate(grid.Cell(cell), cell, &result);
    }
  });
  Continuer(field, &result).Find(grid);
  if (cv::countNonZero(result.component) == 0) {
    throw std::invalid_argument(
        "The normal map shows no surface: all normals are zero, not finite or at right angles to "
        "the line of sight; expected unit normals in the camera's frame.");
  }
  return result;
}

}  // namespace stereo_sgmp
