#ifndef STEREO_SGMP_MATCH_INPUTS_H_
#define STEREO_SGMP_MATCH_INPUTS_H_

#include <optional>

#include <opencv2/core.hpp>

#include "stereo_sgmp/cost_volume.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// What is known of a pair beyond its two images. Each variant of the prior says what it needs;
// the rest may stay empty. Maps are of the size of the left image and in its pixels.
struct MatchInputs {
  // A disparity surface to stay parallel to (Variant::kGs, kGp): CV_32F, pixels; not finite where
  // it is not known, and there is no prior there.
  cv::Mat surface;

  // Unit normals of what is seen (kGni, kGnv): CV_32FC3, x right, y down, z forward, turned
  // towards the camera; zero or not finite where they are not known.
  cv::Mat normals;

  // Where depth is known to be discontinuous (kGni, kGnv): CV_8U, not 0 at both pixels beside the
  // discontinuity; may be empty. Without it, or besides it, surfaces are taken to end where
  // normals change abruptly.
  cv::Mat discontinuities;

  // The camera of the pair (kGni, kGnv, kMw).
  std::optional<StereoCamera> camera;

  // Matching costs made elsewhere, in place of those of CostOptions; not owned. The coarse pass
  // still computes its own costs from the images.
  const CostVolume* costs = nullptr;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_MATCH_INPUTS_H_
