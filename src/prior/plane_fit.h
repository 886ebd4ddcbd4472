// Least-squares planes in disparity space.
#ifndef STEREO_SGMP_PRIOR_PLANE_FIT_H_
#define STEREO_SGMP_PRIOR_PLANE_FIT_H_

#include <cstddef>

#include "stereo_sgmp/disparity_plane.h"

namespace stereo_sgmp {

// Variance in px^2 added to both axes: negligible beside the extent of a real region, enough to
// keep the slope of a line or a point of samples finite.
constexpr double kSlopeRegularisation = 1e-3;

struct DisparitySample {
  float x = 0.0F;
  float y = 0.0F;
  float disparity = 0.0F;
};

// Sums over samples (x, y, d) from which the plane d = a x + b y + c with the least squared error
// follows. The plane is fitted around the mean, so coordinates may be far from the origin.
class PlaneMoments {
 public:
  // Here, for the loops over samples.
  void Add(double x, double y, double disparity, double weight = 1.0) {
    const double wx = weight * x;
    const double wy = weight * y;
    const double wd = weight * disparity;
    n_ += weight;
    x_ += wx;
    y_ += wy;
    d_ += wd;
    xx_ += wx * x;
    xy_ += wx * y;
    yy_ += wy * y;
    xd_ += wx * disparity;
    yd_ += wy * disparity;
    dd_ += wd * disparity;
  }
  void Merge(const PlaneMoments& other);

  // Sum of the weights.
  double weight() const { return n_; }

  // The plane through the mean; where the samples leave a slope open (all in one line or point)
  // it is the flattest one. The zero plane without samples.
  DisparityPlane Fit() const;

  // Root mean square distance of the samples from `plane`, in disparities. 0 without samples.
  double Rms(const DisparityPlane& plane) const;

 private:
  struct Centred;
  Centred AboutMean() const;

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

// Fits again with Huber's weights min(1, threshold / |residual|), starting from `plane`: samples
// of a neighbouring surface then bend the plane little. `threshold` is in disparities, > 0.
DisparityPlane RefitHuber(const DisparitySample* samples, std::size_t count, DisparityPlane plane,
                          double threshold, int iterations);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_PLANE_FIT_H_
