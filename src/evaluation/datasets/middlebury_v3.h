// The Middlebury stereo evaluation v3 (Scharstein et al., GCPR 2014), at each of its resolutions,
// and ETH3D's two-view benchmark, which has the same files.
#ifndef STEREO_SGMP_EVALUATION_DATASETS_MIDDLEBURY_V3_H_
#define STEREO_SGMP_EVALUATION_DATASETS_MIDDLEBURY_V3_H_

#include "evaluation/datasets/scene_layout.h"

namespace stereo_sgmp {

// A folder per scene: im0.png and im1.png, disp0GT.pfm or disp0.pfm, and where they exist
// mask0nocc.png, calib.txt and normals0.pfm (an addition of this project).
extern const SceneLayout kMiddleburyV3Layout;

// Writes what is known of the scene into `folder`, which is created if needed.
void SaveMiddleburyV3(const std::filesystem::path& folder, const StereoScene& scene);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_DATASETS_MIDDLEBURY_V3_H_
