// Stereo pairs of texture that repeats along the rows.
#ifndef STEREO_SGMP_TEST_MATCHER_REPEATING_PAIR_H_
#define STEREO_SGMP_TEST_MATCHER_REPEATING_PAIR_H_

#include <opencv2/core.hpp>

namespace stereo_sgmp {

struct RepeatingPair {
  cv::Mat left;   // CV_8U
  cv::Mat right;  // CV_8U
};

// Tiles of `period` pixels on a slanted wall and on two panels in front of it, with a little sensor
// noise and stains of `stains` gray levels that do not repeat. Disparities lie in [10, 32].
RepeatingPair MakeRepeatingPair(cv::Size size, double period, double stains);

// The same tiles on one wall, clean; what stands at x is at x - disparity in a wall with
// `disparity`.
cv::Mat RepeatingWall(cv::Size size, double period, double disparity = 0.0);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_TEST_MATCHER_REPEATING_PAIR_H_
