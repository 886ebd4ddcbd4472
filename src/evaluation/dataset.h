// Folders of stereo pairs with ground truth, in the layout of the Middlebury evaluation v3.
#ifndef STEREO_SGMP_EVALUATION_DATASET_H_
#define STEREO_SGMP_EVALUATION_DATASET_H_

#include <optional>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "io/calib.h"

namespace stereo_sgmp {

struct StereoScene {
  std::string name;
  cv::Mat left;       // im0.png
  cv::Mat right;      // im1.png
  cv::Mat disparity;  // disp0GT.pfm: CV_32F, infinite where it is not known
  cv::Mat mask;       // mask0nocc.png: CV_8U, 255 seen by both cameras; empty without the file
  std::optional<Calibration> calibration;  // calib.txt, where there is one
};

// The scenes among `folders` and in them, in the order given and by name within one folder.
// Throws std::invalid_argument for a folder that neither is nor contains a scene.
std::vector<std::string> FindScenes(const std::vector<std::string>& folders);

// Throws std::invalid_argument for files that are missing, malformed or do not fit together.
StereoScene LoadScene(const std::string& folder);

// Writes the scene into `folder`, which is created if needed.
void SaveScene(const std::string& folder, const StereoScene& scene);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_DATASET_H_
