#include "prior/manhattan/orientation_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <opencv2/imgproc.hpp>

#include "prior/coarse_scale.h"
#include "prior/manhattan/viewing_ray.h"

namespace stereo_sgmp {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Sine of the angle between viewing ray and plane below which a plane is seen edge on.
constexpr double kHorizon = 0.02;

class Sweeper {
 public:
  Sweeper(const ManhattanFrame& frame, const StereoCamera& camera, cv::Size full, cv::Size size)
      : frame_(frame), camera_(camera), scale_(CoarseScale::Between(full, size)) {
    for (cv::Mat& mask : barriers_) mask = cv::Mat::zeros(size, CV_8UC1);
    for (auto& of_class : swept_) {
      for (cv::Mat& mask : of_class) mask = cv::Mat::zeros(size, CV_8UC1);
    }
  }

  // 4-connected, so that no ray slips through between two pixels.
  void AddBarrier(const LineSegment& line, std::size_t column) {
    cv::line(barriers_[column], Pixel(ToMap(line.start)), Pixel(ToMap(line.end)), cv::Scalar(255),
             1, cv::LINE_4);
  }

  void Sweep(const LineSegment& line, std::size_t column) {
    for (const std::size_t along : {(column + 1) % 3, (column + 2) % 3}) {
      SweepOneWay(line, column, along, 1.0);
      SweepOneWay(line, column, along, -1.0);
    }
  }

  // Where lines of both other directions have been swept along each other.
  cv::Mat FacedBy(std::size_t normal) const {
    const std::size_t a = (normal + 1) % 3;
    const std::size_t b = (normal + 2) % 3;
    return swept_[a][b] & swept_[b][a];
  }

 private:
  static cv::Point Pixel(const Vector2d& p) { return {cvRound(p.x()), cvRound(p.y())}; }

  Vector2d ToMap(const Vector2d& p) const {
    return {(p.x() + 0.5) / scale_.x - 0.5, (p.y() + 0.5) / scale_.y - 0.5};
  }
  Vector3d RayOf(const Vector2d& p) const {
    return ViewingRay(camera_, (p.x() + 0.5) * scale_.x - 0.5, (p.y() + 0.5) * scale_.y - 0.5);
  }

  void SweepOneWay(const LineSegment& line, std::size_t column, std::size_t along, double sign) {
    const Vector2d start = ToMap(line.start);
    const Vector2d end = ToMap(line.end);
    const int steps = std::max(1, static_cast<int>(std::ceil((end - start).norm())));
    std::array<cv::Point, 4> strip;
    for (int i = 0; i <= steps; ++i) {
      const Vector2d p = start + (end - start) * (static_cast<double>(i) / steps);
      strip[0] = strip[3];
      strip[1] = strip[2];
      strip[2] = Pixel(March(p, 3 - column - along, along, sign));
      strip[3] = Pixel(p);
      if (i == 0) continue;
      cv::fillConvexPoly(swept_[column][along], strip.data(), 4, cv::Scalar(255));
    }
  }

  // The last point before a line of the direction `normal`, the horizon or the border.
  Vector2d March(Vector2d p, std::size_t normal, std::size_t along, double sign) const {
    const Vector3d direction = frame_.directions.col(static_cast<int>(along));
    const Vector3d facing = frame_.directions.col(static_cast<int>(normal));
    const Vector3d ray = RayOf(p);
    Vector2d step((direction.x() * ray.z() - ray.x() * direction.z()) / scale_.x,
                  (direction.y() * ray.z() - ray.y() * direction.z()) / scale_.y);
    if (step.isZero()) return p;
    step *= sign / step.cwiseAbs().maxCoeff();
    const double side = facing.dot(ray) < 0.0 ? -1.0 : 1.0;
    const cv::Mat& barrier = barriers_[normal];
    const cv::Rect image(cv::Point(), barrier.size());
    for (Vector2d next = p + step; image.contains(Pixel(next)); next += step) {
      const Vector3d next_ray = RayOf(next);
      if (side * facing.dot(next_ray) < kHorizon * next_ray.norm()) break;
      if (barrier.at<std::uint8_t>(Pixel(next)) != 0) break;
      p = next;
    }
    return p;
  }

  const ManhattanFrame& frame_;
  const StereoCamera& camera_;
  CoarseScale scale_;
  std::array<cv::Mat, 3> barriers_;              // lines of a class
  std::array<std::array<cv::Mat, 3>, 3> swept_;  // [class of the lines][swept along]
};

}  // namespace

cv::Mat MapOrientations(const std::vector<LineSegment>& lines, const ManhattanFrame& frame,
                        const StereoCamera& camera, cv::Size full, cv::Size size) {
  Sweeper sweeper(frame, camera, full, size);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (frame.classes[i] < 0) continue;
    sweeper.AddBarrier(lines[i], static_cast<std::size_t>(frame.classes[i]));
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (frame.classes[i] < 0) continue;
    sweeper.Sweep(lines[i], static_cast<std::size_t>(frame.classes[i]));
  }
  const std::array<cv::Mat, 3> faced = {sweeper.FacedBy(0), sweeper.FacedBy(1), sweeper.FacedBy(2)};
  cv::Mat map(size, CV_16SC1, cv::Scalar(-1));
  for (int c = 0; c < 3; ++c) {
    const std::size_t i = static_cast<std::size_t>(c);
    map.setTo(c, faced[i] & ~faced[(i + 1) % 3] & ~faced[(i + 2) % 3]);
  }
  return map;
}

}  // namespace stereo_sgmp
