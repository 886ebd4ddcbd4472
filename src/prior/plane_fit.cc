#include "prior/plane_fit.h"

#include <algorithm>
#include <cmath>

namespace stereo_sgmp {
// Means, and mean products of the deviations from them.
struct PlaneMoments::Centred {
  double x, y, d;
  double xx, xy, yy, xd, yd, dd;
};

void PlaneMoments::Merge(const PlaneMoments& other) {
  n_ += other.n_;
  x_ += other.x_;
  y_ += other.y_;
  d_ += other.d_;
  xx_ += other.xx_;
  xy_ += other.xy_;
  yy_ += other.yy_;
  xd_ += other.xd_;
  yd_ += other.yd_;
  dd_ += other.dd_;
}

PlaneMoments::Centred PlaneMoments::AboutMean() const {
  const double x = x_ / n_;
  const double y = y_ / n_;
  const double d = d_ / n_;
  return {x,
          y,
          d,
          xx_ / n_ - x * x,
          xy_ / n_ - x * y,
          yy_ / n_ - y * y,
          xd_ / n_ - x * d,
          yd_ / n_ - y * d,
          dd_ / n_ - d * d};
}

DisparityPlane PlaneMoments::Fit() const {
  if (n_ <= 0.0) return {};
  const Centred m = AboutMean();
  const double xx = m.xx + kSlopeRegularisation;
  const double yy = m.yy + kSlopeRegularisation;
  const double determinant = xx * yy - m.xy * m.xy;
  const double a = (m.xd * yy - m.yd * m.xy) / determinant;
  const double b = (m.yd * xx - m.xd * m.xy) / determinant;
  return {a, b, m.d - a * m.x - b * m.y};
}

double PlaneMoments::Rms(const DisparityPlane& plane) const {
  if (n_ <= 0.0) return 0.0;
  const Centred m = AboutMean();
  const double a = plane.a;
  const double b = plane.b;
  const double offset = plane.At(m.x, m.y) - m.d;
  const double mean_square = m.dd - 2.0 * (a * m.xd + b * m.yd) + a * a * m.xx +
                             2.0 * a * b * m.xy + b * b * m.yy + offset * offset;
  return std::sqrt(std::max(0.0, mean_square));
}

DisparityPlane RefitHuber(const DisparitySample* samples, std::size_t count, DisparityPlane plane,
                          double threshold, int iterations) {
  for (int i = 0; i < iterations; ++i) {
    PlaneMoments moments;
    for (const DisparitySample* s = samples; s != samples + count; ++s) {
      const double residual = std::abs(plane.At(s->x, s->y) - s->disparity);
      const double weight = residual <= threshold ? 1.0 : threshold / residual;
      moments.Add(s->x, s->y, s->disparity, weight);
    }
    plane = moments.Fit();
  }
  return plane;
}

}  // namespace stereo_sgmp
