#ifndef STEREO_SGMP_SCENE_GROUND_TRUTH_H_
#define STEREO_SGMP_SCENE_GROUND_TRUTH_H_

#include <vector>

#include <opencv2/core.hpp>

#include "common/thread_pool.h"
#include "scene/renderer.h"
#include "scene/world.h"
#include "stereo_sgmp/disparity_plane.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// What is exactly known of the centre of each pixel of the left view; as in GeneratedScene.
struct GroundTruth {
  cv::Mat disparity;
  cv::Mat mask;
  cv::Mat normals;
  cv::Mat labels;
  std::vector<DisparityPlane> planes;
};

// `right_shift` tells which rows the right picture ends at.
GroundTruth RenderGroundTruth(const World& world, const StereoCamera& camera,
                              const RowShift& right_shift, cv::Size size, ThreadPool* pool);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_SCENE_GROUND_TRUTH_H_
