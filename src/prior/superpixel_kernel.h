// The inner loop of SLIC.
#ifndef STEREO_SGMP_PRIOR_SUPERPIXEL_KERNEL_H_
#define STEREO_SGMP_PRIOR_SUPERPIXEL_KERNEL_H_

#include <cstddef>
#include <cstdint>

namespace stereo_sgmp {

struct ClusterCentre {
  float channel[3];
  float x;
  float y;
};

// A rectangle of pixels in continuous planes that share one width.
struct ClusterWindow {
  const float* channel[3];  // of its top left pixel; only the first of a gray image
  int channels = 0;         // 1 or 3
  float* nearest;           // squared distance to the nearest centre so far
  std::int32_t* cluster;    // that centre
  std::ptrdiff_t stride = 0;
  int x = 0;  // of its top left pixel
  int y = 0;
  int width = 0;
  int height = 0;
};

// Gives the pixels that are nearer to `centre` than to any before to cluster `label`. The squared
// distance is that in colour plus `spatial_weight` times that in the image.
void AssignWindow(const ClusterWindow& window, const ClusterCentre& centre, float spatial_weight,
                  std::int32_t label);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_SUPERPIXEL_KERNEL_H_
