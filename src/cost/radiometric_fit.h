#ifndef STEREO_SGMP_COST_RADIOMETRIC_FIT_H_
#define STEREO_SGMP_COST_RADIOMETRIC_FIT_H_

#include <vector>

#include <opencv2/core.hpp>

namespace stereo_sgmp {

// How the gray levels of the right image become those of the left: I_l = gain I_r + offset.
struct RadiometricFit {
  double gain = 1.0;
  double offset = 0.0;     // gray levels
  double ad_weight = 1.0;  // 0..1: how far absolute differences can be trusted
};

// Fits the gray levels of the two images of a pair. Keeps its buffers from frame to frame.
class RadiometricFitter {
 public:
  // Robust fit between the matched pixels of a pair. `left`, `right`: CV_8UC1; `disparity`:
  // CV_32F, pixels of these images; `confident`: CV_8U, 0 where the disparity is not to be used;
  // all of one size. The fit stays the identity unless it lowers the median absolute deviation of
  // the gray levels by 20 %. Vignetting, reflections and the like remain: ad_weight falls from 1
  // to 0 as the remaining deviation rises from 3 to 8 gray levels. Too few matches give the
  // identity.
  RadiometricFit Fit(const cv::Mat& left, const cv::Mat& right, const cv::Mat& disparity,
                     const cv::Mat& confident);

 private:
  // Gray levels of one matched point.
  struct GrayPair {
    float left = 0.0F;
    float right = 0.0F;
  };

  static double Error(const GrayPair& pair, const RadiometricFit& fit);
  void CollectPairs(const cv::Mat& left, const cv::Mat& right, const cv::Mat& disparity,
                    const cv::Mat& confident);
  double MedianDeviation(const RadiometricFit& fit);
  // Least squares with Cauchy weights of the given scale around `fit`. Returns false, and leaves
  // `fit` alone, where the gray levels do not determine a line.
  bool Refit(double scale, RadiometricFit* fit) const;

  std::vector<GrayPair> pairs_;
  std::vector<double> deviations_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_RADIOMETRIC_FIT_H_
