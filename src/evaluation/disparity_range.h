#ifndef STEREO_SGMP_EVALUATION_DISPARITY_RANGE_H_
#define STEREO_SGMP_EVALUATION_DISPARITY_RANGE_H_

#include "evaluation/stereo_scene.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// How many disparities to search from options.min_disparity on: ndisp of the calibration, else
// what covers the ground truth and a tenth more (so that it is not given away where the scene
// ends), else options.num_disparities; at most the width of the image but for ndisp.
int DisparitiesToSearch(const StereoScene& scene, const Options& options);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_DISPARITY_RANGE_H_
