#include "prior/manhattan/vanishing_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "prior/manhattan/polar_grid.h"
#include "prior/manhattan/viewing_ray.h"

namespace stereo_sgmp {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kDegree = 3.14159265358979323846 / 180.0;

// Lines whose pairs are searched, longest first.
constexpr std::size_t kMaxLines = 500;
// Pairs that give a first direction. With half of the lines outliers and the rest shared by three
// directions a pair fits one in 12; then 300 miss all three with a chance of 1e-11.
constexpr int kHypotheses = 300;
// Steps of the second direction about the first.
constexpr int kTurns = 360;
// Pairs nearly in one line have no sharp intersection: sine of the angle between their planes.
constexpr double kMinPairSine = 0.02;
// Added to sin 2D in the weight of a pair with the angle D in the image.
constexpr double kPairOffset = 0.2;

// Angle between a line and the direction to a vanishing point up to which it belongs to it. The
// first round is wider, as the grid is only good to a degree.
constexpr double kFirstAngle = 3.0 * kDegree;
constexpr double kInlierAngle = 2.0 * kDegree;
constexpr int kRefinements = 8;
// Lines that nearly run through the vanishing point tell nothing: sine of their distance.
constexpr double kMinDistance = 0.05;

// Shares of the length of all lines.
constexpr double kMinFirstShares = 0.08;
constexpr double kMinThirdShare = 0.03;
constexpr double kMinInliers = 0.5;

// A line as the camera sees it.
struct SightLine {
  Vector3d normal;  // of the plane through the line and the camera's centre, unit
  Vector3d middle;  // towards the line's middle, unit
  Eigen::Vector2d along;
  double length = 0.0;  // pixels
};

std::vector<SightLine> See(const std::vector<LineSegment>& lines, const StereoCamera& camera) {
  std::vector<SightLine> seen;
  seen.reserve(lines.size());
  for (const LineSegment& line : lines) {
    const Vector3d start = ViewingRay(camera, line.start.x(), line.start.y());
    const Vector3d end = ViewingRay(camera, line.end.x(), line.end.y());
    const double length = line.Length();
    seen.push_back({start.cross(end).normalized(), (start + end).normalized(),
                    (line.end - line.start) / length, length});
  }
  return seen;
}

void FillGrid(const std::vector<SightLine>& lines, PolarGrid* grid) {
  const std::size_t count = std::min(lines.size(), kMaxLines);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vector3d direction = lines[i].normal.cross(lines[j].normal);
      if (direction.norm() < kMinPairSine) continue;
      const double cosine = lines[i].along.dot(lines[j].along);
      const double sin_2d =
          2.0 * std::abs(cosine) * std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
      grid->Add(direction, std::sqrt(lines[i].length * lines[j].length) * (sin_2d + kPairOffset));
    }
  }
  grid->Smooth();
}

// The best second and third direction for a given first one.
struct Triple {
  Matrix3d directions = Matrix3d::Identity();
  double response = -1.0;
};

Triple BestTurn(const Vector3d& first, const PolarGrid& grid) {
  // A quarter turn brings the second direction to the third, half a turn to its opposite.
  constexpr int kQuarter = kTurns / 2;
  const Vector3d second = first.unitOrthogonal();
  const Vector3d third = first.cross(second);
  std::array<double, kTurns> responses;
  for (int i = 0; i < kTurns; ++i) {
    const double angle = i * 180.0 / kTurns * kDegree;
    responses[static_cast<std::size_t>(i)] =
        grid.At(std::cos(angle) * second + std::sin(angle) * third);
  }
  int best = 0;
  const auto response = [&responses](int i) {
    return responses[static_cast<std::size_t>(i)] +
           responses[static_cast<std::size_t>(i + kQuarter)];
  };
  for (int i = 1; i < kQuarter; ++i) {
    if (response(i) > response(best)) best = i;
  }
  const double angle = best * 180.0 / kTurns * kDegree;
  Triple triple;
  triple.directions.col(0) = first;
  triple.directions.col(1) = std::cos(angle) * second + std::sin(angle) * third;
  triple.directions.col(2) = first.cross(Vector3d(triple.directions.col(1)));
  triple.response = grid.At(first) + response(best);
  return triple;
}

Triple Search(const std::vector<SightLine>& lines) {
  const auto grid = std::make_unique<PolarGrid>();
  FillGrid(lines, grid.get());
  // The raw numbers: standard distributions differ from library to library.
  std::mt19937 random(1);
  const auto count = static_cast<std::uint32_t>(std::min(lines.size(), kMaxLines));
  Triple best;
  for (int i = 0; i < kHypotheses; ++i) {
    const SightLine& one = lines[random() % count];
    const SightLine& other = lines[random() % count];
    const Vector3d first = one.normal.cross(other.normal);
    if (first.norm() < kMinPairSine) continue;
    const Triple triple = BestTurn(first.normalized(), *grid);
    if (triple.response > best.response) best = triple;
  }
  return best;
}

// The direction whose vanishing point the line points to if it turns least about its middle.
std::int8_t ClassOf(const SightLine& line, const Matrix3d& directions, double max_angle) {
  double best = std::sin(max_angle);
  std::int8_t column = -1;
  for (std::int8_t c = 0; c < 3; ++c) {
    const Vector3d direction = directions.col(c);
    const double distance = line.middle.cross(direction).norm();
    if (distance < kMinDistance) continue;
    const double residual = std::abs(line.normal.dot(direction)) / distance;
    if (residual >= best) continue;
    best = residual;
    column = c;
  }
  return column;
}

// Gauss-Newton over rotations R exp([w]): the residual of a line with normal N, in the frame
// M = R'N, of column e changes by (e x M).w. Lines are weighted by their squared length, as their
// direction is uncertain by 1 / length.
Matrix3d Refine(const std::vector<SightLine>& lines, Matrix3d directions) {
  for (int i = 0; i < kRefinements; ++i) {
    Matrix3d normal_matrix = Matrix3d::Zero();
    Vector3d right_side = Vector3d::Zero();
    for (const SightLine& line : lines) {
      const int column = ClassOf(line, directions, i == 0 ? kFirstAngle : kInlierAngle);
      if (column < 0) continue;
      const Vector3d direction = directions.col(column);
      const double weight = line.length / line.middle.cross(direction).norm();
      const Vector3d local = directions.transpose() * line.normal;
      const Vector3d gradient = weight * Vector3d::Unit(column).cross(local);
      normal_matrix += gradient * gradient.transpose();
      right_side -= gradient * (weight * line.normal.dot(direction));
    }
    // Holds turns that no line tells anything of.
    normal_matrix.diagonal().array() += 1e-9 * normal_matrix.trace() + 1e-12;
    const Vector3d turn = normal_matrix.ldlt().solve(right_side);
    if (turn.isZero()) break;
    directions *= Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  }
  return directions;
}

Matrix3d Ordered(const Matrix3d& directions) {
  const auto towards = [](const Vector3d& v, const Vector3d& axis) {
    return Vector3d(v.dot(axis) < 0.0 ? -v : v);
  };
  Eigen::Index vertical = 0;
  directions.row(1).cwiseAbs().maxCoeff(&vertical);
  Eigen::Index forward = (vertical + 1) % 3;
  const Eigen::Index other = (vertical + 2) % 3;
  if (std::abs(directions(2, other)) > std::abs(directions(2, forward))) forward = other;
  Matrix3d ordered;
  ordered.col(1) = towards(directions.col(vertical), Vector3d::UnitY());
  ordered.col(2) = towards(directions.col(forward), Vector3d::UnitZ());
  ordered.col(0) = Vector3d(ordered.col(1)).cross(Vector3d(ordered.col(2)));
  return ordered;
}

bool IsManhattan(const std::vector<SightLine>& lines, const std::vector<std::int8_t>& classes) {
  double total = 0.0;
  std::array<double, 3> shares{};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    total += lines[i].length;
    if (classes[i] >= 0) shares[static_cast<std::size_t>(classes[i])] += lines[i].length;
  }
  std::sort(shares.begin(), shares.end());
  return shares[1] >= kMinFirstShares * total && shares[0] >= kMinThirdShare * total &&
         shares[0] + shares[1] + shares[2] >= kMinInliers * total;
}

}  // namespace

std::optional<ManhattanFrame> FindManhattanFrame(const std::vector<LineSegment>& lines,
                                                 const StereoCamera& camera) {
  if (lines.size() < 3) return std::nullopt;
  const std::vector<SightLine> seen = See(lines, camera);
  const Triple found = Search(seen);
  if (found.response < 0.0) return std::nullopt;
  ManhattanFrame frame;
  frame.directions = Ordered(Refine(seen, found.directions));
  for (const SightLine& line : seen) {
    frame.classes.push_back(ClassOf(line, frame.directions, kInlierAngle));
  }
  if (!IsManhattan(seen, frame.classes)) return std::nullopt;
  return frame;
}

}  // namespace stereo_sgmp
