#ifndef STEREO_SGMP_PRIOR_REGION_GROWTH_KERNEL_H_
#define STEREO_SGMP_PRIOR_REGION_GROWTH_KERNEL_H_

#include <cstddef>
#include <cstdint>
#include <limits>

#include "prior/plane_fit.h"
#include "stereo_sgmp/disparity_plane.h"

namespace stereo_sgmp {

// Distance from the plane at which a pixel still belongs to it, coarse disparities.
constexpr float kGrowRange = 0.6F;

// Pixels without a fitting disparity that growth steps over, less one.
constexpr int kGap = 2;
// Disparities that are read to the right of a pixel, to the end of a vector.
constexpr int kGapOverrun = 8;

// A region of pixels of an image that is padded by kGap, to the right by kGapOverrun.
struct Region {
  float* disparity;         // of the pixel (0, 0); not a number where none may be taken
  std::uint8_t* reached;    // of it too; set to 1 where a pixel is taken
  int stride;               // of both
  DisparitySample* pixels;  // in the order in which they are taken, with room for all there are
  std::size_t count;
};

// Moves the pixel (x, y) from the image to the region.
inline void TakePixel(int x, int y, Region* region) {
  const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(y) * region->stride + x;
  region->pixels[region->count++] = {static_cast<float>(x), static_cast<float>(y),
                                     region->disparity[i]};
  region->disparity[i] = std::numeric_limits<float>::quiet_NaN();
  region->reached[i] = 1;
}

// Around the pixels of the region from `next` on, those that it takes meanwhile included, takes
// what is near `plane` and not further away than kGap in x and y. Ends when all are done or there
// are more than `most`, and returns the first that is not done.
std::size_t GrowRegion(const DisparityPlane& plane, std::size_t next, double most, Region* region);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_REGION_GROWTH_KERNEL_H_
