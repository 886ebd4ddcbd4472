// The Middlebury data sets of 2001 to 2006, whose ground truth is 8-bit pictures.
#ifndef STEREO_SGMP_EVALUATION_DATASETS_MIDDLEBURY_PICTURES_H_
#define STEREO_SGMP_EVALUATION_DATASETS_MIDDLEBURY_PICTURES_H_

#include "evaluation/datasets/scene_layout.h"

namespace stereo_sgmp {

// 2001 and 2003, a folder per scene: im2, im6, disp2 and, to tell what both cameras see, disp6;
// each .png, .ppm or .pgm. The scale follows from the width: 8 below that of 2003 at quarter size
// (450 pixels), then 4, from half size (900) on 2, from full size (1800) on 1. 2001's tsukuba and
// map differ: name their scale.
extern const SceneLayout kMiddlebury2003Layout;

// 2005 and 2006, a folder per scene: view1.png, view5.png, disp1.png and, as above, disp5.png.
// The scale follows from the width: 3 at third size (up to 550 pixels), 2 at half size (up to
// 1000), 1 at full size.
extern const SceneLayout kMiddlebury2006Layout;

// A mask as StereoScene's, from the ground truth of both images, CV_32F of one size: 255 where
// the pixel of the right image that a left one maps to maps back to it within a pixel, else 128;
// 0 where the left ground truth is not known.
cv::Mat SeenByBoth(const cv::Mat& left_truth, const cv::Mat& right_truth);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_DATASETS_MIDDLEBURY_PICTURES_H_
