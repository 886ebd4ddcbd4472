#include "geometry/normals_from_disparity.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

namespace stereo_sgmp {
namespace {

constexpr int kRadius = 3;
constexpr int kMinPixels = 6;
// Least spread of the pixels of a fit (determinant of their covariance, pixels^4): that of pixels
// on one line is 0, of two by three pixels 1/6.
constexpr double kMinSpread = 0.05;
// Variance (pixels^2) up to which a plane fits: quantised or noisy ground truth does not matter.
constexpr double kGoodFit = 0.1 * 0.1;

struct Fit {
  DisparityPlane plane;  // in pixels of the image
  double variance = std::numeric_limits<double>::infinity();
};

// Sums of the pixels of one surface, relative to one of them, for a least-squares plane.
class Moments {
 public:
  void Add(double x, double y, double d) {
    n_ += 1.0;
    x_ += x;
    y_ += y;
    d_ += d;
    xx_ += x * x;
    xy_ += x * y;
    yy_ += y * y;
    xd_ += x * d;
    yd_ += y * d;
    dd_ += d * d;
  }

  // Nothing where the pixels do not determine a plane.
  std::optional<Fit> Solve() const {
    if (n_ < kMinPixels) return std::nullopt;
    const double xx = Covariance(xx_, x_, x_);
    const double xy = Covariance(xy_, x_, y_);
    const double yy = Covariance(yy_, y_, y_);
    const double xd = Covariance(xd_, x_, d_);
    const double yd = Covariance(yd_, y_, d_);
    const double spread = xx * yy - xy * xy;
    if (spread < kMinSpread) return std::nullopt;
    Fit fit;
    fit.plane.a = (xd * yy - yd * xy) / spread;
    fit.plane.b = (yd * xx - xd * xy) / spread;
    fit.plane.c = (d_ - fit.plane.a * x_ - fit.plane.b * y_) / n_;
    const double squares = n_ * (Covariance(dd_, d_, d_) - fit.plane.a * xd - fit.plane.b * yd);
    fit.variance = squares / (n_ - 3.0);
    return fit;
  }

 private:
  double Covariance(double product, double a, double b) const {
    return product / n_ - (a / n_) * (b / n_);
  }

  double n_ = 0.0;
  double x_ = 0.0;
  double y_ = 0.0;
  double d_ = 0.0;
  double xx_ = 0.0;
  double xy_ = 0.0;
  double yy_ = 0.0;
  double xd_ = 0.0;
  double yd_ = 0.0;
  double dd_ = 0.0;
};

// The plane through the window around `center`, of the pixels on the surface of p; relative to p.
std::optional<Fit> FitWindow(const cv::Mat& disparity, cv::Point p, cv::Point center) {
  const double origin = disparity.at<float>(p);
  Moments moments;
  const cv::Rect window(center.x - kRadius, center.y - kRadius, 2 * kRadius + 1, 2 * kRadius + 1);
  const cv::Rect inside = window & cv::Rect(cv::Point(), disparity.size());
  for (int y = inside.y; y < inside.br().y; ++y) {
    const float* row = disparity.ptr<float>(y);
    for (int x = inside.x; x < inside.br().x; ++x) {
      const double step = static_cast<double>(row[x]) - origin;
      const int distance = std::max(std::abs(x - p.x), std::abs(y - p.y));
      // False too where row[x] is not finite.
      if (std::abs(step) <= distance) moments.Add(x - p.x, y - p.y, step);
    }
  }
  return moments.Solve();
}

std::optional<Fit> BestFit(const cv::Mat& disparity, cv::Point p) {
  std::optional<Fit> best = FitWindow(disparity, p, p);
  if (best && best->variance <= kGoodFit) return best;
  for (const int dy : {-kRadius, 0, kRadius}) {
    for (const int dx : {-kRadius, 0, kRadius}) {
      const std::optional<Fit> fit = FitWindow(disparity, p, p + cv::Point(dx, dy));
      if (fit && (!best || fit->variance < best->variance)) best = fit;
    }
  }
  return best;
}

cv::Vec3f NormalAt(const cv::Mat& disparity, const StereoCamera& camera, cv::Point p) {
  const double origin = disparity.at<float>(p);
  const bool in_front = std::isfinite(origin) && origin + camera.doffs > 0.0;
  const std::optional<Fit> fit = in_front ? BestFit(disparity, p) : std::nullopt;
  if (!fit) return cv::Vec3f::all(0.0f);
  DisparityPlane plane = fit->plane;
  plane.c += origin - plane.a * p.x - plane.b * p.y;
  const Eigen::Vector3d normal = camera.ToSpace(plane).normal;
  return cv::Vec3d(normal.x(), normal.y(), normal.z());
}

}  // namespace

cv::Mat NormalsFromDisparity(const cv::Mat& disparity, const StereoCamera& camera) {
  camera.Check();
  if (disparity.type() != CV_32FC1) {
    throw std::invalid_argument("The disparities for normals are of OpenCV type " +
                                std::to_string(disparity.type()) +
                                ", expected CV_32FC1; convert them.");
  }
  cv::Mat normals(disparity.size(), CV_32FC3);
  cv::parallel_for_(cv::Range(0, disparity.rows), [&](const cv::Range& rows) {
    for (int y = rows.start; y < rows.end; ++y) {
      for (int x = 0; x < disparity.cols; ++x) {
        normals.at<cv::Vec3f>(y, x) = NormalAt(disparity, camera, {x, y});
      }
    }
  });
  return normals;
}

}  // namespace stereo_sgmp
