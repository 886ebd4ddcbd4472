// The training frames of KITTI 2012 (Geiger et al., CVPR 2012) and 2015 (Menze and Geiger, CVPR
// 2015).
#ifndef STEREO_SGMP_EVALUATION_DATASETS_KITTI_H_
#define STEREO_SGMP_EVALUATION_DATASETS_KITTI_H_

#include "evaluation/datasets/scene_layout.h"

namespace stereo_sgmp {

// The folder `training`: image_2 and image_3 (2015) or image_0 and image_1 (2012), with the ground
// truth disp_noc_0 (2015) or disp_noc (2012), 16-bit pictures of 256 times the disparity that hold
// only what both cameras see. Each frame NUMBER_10.png is a scene.
extern const SceneLayout kKittiLayout;

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_DATASETS_KITTI_H_
