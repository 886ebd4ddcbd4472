#ifndef STEREO_SGMP_SCENE_RENDERER_H_
#define STEREO_SGMP_SCENE_RENDERER_H_

#include <opencv2/core.hpp>

#include "common/thread_pool.h"
#include "scene/texture.h"
#include "scene/view.h"
#include "scene/world.h"

namespace stereo_sgmp {

// y' = scale * y + offset: the row of the picture where the ideal camera has row y.
struct RowShift {
  double scale = 1.0;
  double offset = 0.0;
};

// The light that reaches each pixel, blue, green, red, 0..1, averaged over 2x2 rays a pixel.
cv::Mat_<cv::Vec3f> RenderView(const World& world, const PinholeView& view, cv::Size size,
                               const RowShift& shift, const ValueNoise& noise, ThreadPool* pool);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_SCENE_RENDERER_H_
