#ifndef STEREO_SGMP_EVALUATION_STEREO_SCENE_H_
#define STEREO_SGMP_EVALUATION_STEREO_SCENE_H_

#include <optional>
#include <string>

#include <opencv2/core.hpp>

#include "io/calib.h"

namespace stereo_sgmp {

// A stereo pair and what is known of it. All maps are of the size of the left image.
struct StereoScene {
  std::string name;
  cv::Mat left;
  cv::Mat right;
  cv::Mat disparity;  // CV_32F, the ground truth of the left image; infinite where not known
  cv::Mat mask;       // CV_8U, 255 seen by both cameras; may be empty
  cv::Mat normals;    // CV_32FC3, as MatchInputs::normals; may be empty
  std::optional<Calibration> calibration;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_STEREO_SCENE_H_
