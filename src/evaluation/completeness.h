#ifndef STEREO_SGMP_EVALUATION_COMPLETENESS_H_
#define STEREO_SGMP_EVALUATION_COMPLETENESS_H_

#include <vector>

#include <opencv2/core.hpp>

namespace stereo_sgmp {

// Error against completeness (the curves of the paper): the evaluated pixels are taken in the order
// of rising uncertainty, and after each number k of them stands the share of bad ones so far.
// Pixels of equal uncertainty come together: among them the bad ones count as evenly spread, so
// that the order of pixels in memory plays no role.
class CompletenessCurve {
 public:
  // `bad` and `evaluated` as in metrics.h; `uncertainty` CV_32F of their size, where NaN counts
  // as the most uncertain. A confidence is given as its negative.
  CompletenessCurve(const cv::Mat& bad, const cv::Mat& evaluated, const cv::Mat& uncertainty);

  // Percent of bad pixels among the `completeness` (0..1) most certain ones. NaN where no pixel
  // is evaluated.
  double ErrorAt(double completeness) const;

  // The area under the curve, percent: the mean over k = 1 ... n of the error among the first k.
  // Lower is better; a measure that sorts at random has the error of the dense map.
  double Area() const;

 private:
  // Pixels and bad pixels up to the end of a group of equal uncertainty.
  struct Step {
    double pixels = 0.0;
    double bad = 0.0;
  };

  // Bad pixels among the first k, step.pixels <= k <= next.pixels.
  static double BadAmong(double k, const Step& step, const Step& next);

  std::vector<Step> steps_;  // starts with {0, 0}
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_COMPLETENESS_H_
