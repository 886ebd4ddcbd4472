#include "prior/normals/normal_field.h"

#include <cmath>

namespace stereo_sgmp {
namespace {

// Larger steps of log(d + doffs) between neighbours are no surface that stereo could follow: half
// of the disparity within two pixels.
constexpr double kLargestStep = 0.35;
// Surfaces seen under a smaller cosine are edge-on; g is the quotient of two such small numbers.
constexpr double kSmallestCosine = 0.01;
// Radians; normals that differ by more belong to a crease, a discontinuity or a rim, beside which g
// is a guess. There the weight falls as of a Geman-McClure penalty, so that errors end up where
// surfaces meet and not within them: in a room with boxes 0.2 % of the slopes were off by more than
// 0.02 px per pixel instead of 5.7 %. Weighing the edges again by the residuals of a first solution
// gained nothing beyond that.
constexpr double kTrustedAngle = 0.15;
// Length of the difference of unit normals. Beyond it, a crease can't be told from a step in depth.
constexpr double kOneSurface = 0.3;

}  // namespace

NormalField::Pixel NormalField::At(int x, int y) const {
  Pixel pixel;
  const auto& given = normals_.at<cv::Vec3f>(y, x);
  const Eigen::Vector3d normal(given[0], given[1], given[2]);
  const double length = normal.norm();
  pixel.ray = {(x - camera_.cx) / camera_.focal_length, (y - camera_.cy) / camera_.focal_length,
               1.0};
  pixel.at_discontinuity = !discontinuities_.empty() && discontinuities_.at<uchar>(y, x) != 0;
  if (!(length > 0.0) || !std::isfinite(length)) return pixel;
  const double cosine = std::abs(normal.dot(pixel.ray)) / (length * pixel.ray.norm());
  if (cosine >= kSmallestCosine) pixel.normal = normal / length;
  return pixel;
}

NormalField::Step NormalField::Between(const Pixel& p, const Pixel& q) {
  if (p.at_discontinuity && q.at_discontinuity) return {};
  const double difference = (p.normal - q.normal).norm();
  if (difference > kOneSurface) return {};
  const double by_p = p.normal.dot(q.ray) / p.normal.dot(p.ray);
  const double by_q = q.normal.dot(q.ray) / q.normal.dot(p.ray);
  if (!(by_p > 0.0 && by_q > 0.0)) return {};  // nan, too
  const double delta = 0.5 * std::log(by_p * by_q);
  if (!(std::abs(delta) <= kLargestStep)) return {};
  const double angle = difference / kTrustedAngle;
  const double root = 1.0 / (1.0 + angle * angle);
  return {delta, root * root};
}

}  // namespace stereo_sgmp
