#ifndef STEREO_SGMP_EVALUATION_METHODS_SGBM_METHOD_H_
#define STEREO_SGMP_EVALUATION_METHODS_SGBM_METHOD_H_

#include <vector>

#include "evaluation/methods/stereo_method.h"

namespace stereo_sgmp {

// OpenCV's StereoSGBM, with the parameters of its documentation: blocks of 5 x 5 pixels, P1 and
// P2 of 8 and 32 times the number of values in a block, a uniqueness ratio of 10 %, a left-right
// check within a pixel and speckles below 100 pixels removed. The images get a margin on their
// left, without which it gives no disparities to the first num_disparities columns. What it marks
// as invalid counts as bad in `raw` and is filled from the background in `dense`.
class SgbmMethod : public StereoMethod {
 public:
  // Names of the modes: sgbm (five paths), sgbm_3way (three) and hh (eight).
  static std::vector<std::string> Names();

  // `threads`: those OpenCV may take; 0 leaves its setting alone. Throws std::invalid_argument
  // when there is no mode of that name.
  SgbmMethod(const std::string& name, int min_disparity, int threads);

  MethodResult Run(const StereoScene& scene, int num_disparities) override;

 private:
  int mode_;
  int min_disparity_;
  int threads_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_METHODS_SGBM_METHOD_H_
