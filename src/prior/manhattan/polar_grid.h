#ifndef STEREO_SGMP_PRIOR_MANHATTAN_POLAR_GRID_H_
#define STEREO_SGMP_PRIOR_MANHATTAN_POLAR_GRID_H_

#include <array>
#include <cstddef>

#include <Eigen/Core>

namespace stereo_sgmp {

// Weights of directions, in cells of one degree of latitude and longitude; a direction and its
// opposite are the same.
class PolarGrid {
 public:
  // `direction` of any length but 0.
  void Add(const Eigen::Vector3d& direction, double weight) { cells_[CellOf(direction)] += weight; }

  // Each cell becomes the sum of itself and its eight neighbours.
  void Smooth();

  double At(const Eigen::Vector3d& direction) const { return cells_[CellOf(direction)]; }

 private:
  // Latitude counts from the optical axis.
  static constexpr int kLatitudes = 90;
  static constexpr int kLongitudes = 360;
  using Cells = std::array<double, std::size_t{kLatitudes} * kLongitudes>;

  static std::size_t CellOf(const Eigen::Vector3d& direction);
  // Also for neighbours beyond the pole, the equator and the ends of the longitudes.
  static std::size_t Index(int latitude, int longitude);

  Cells cells_{};
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_MANHATTAN_POLAR_GRID_H_
