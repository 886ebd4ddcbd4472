#ifndef STEREO_SGMP_IMAGES_PIXEL_DIFFERENCE_KERNEL_H_
#define STEREO_SGMP_IMAGES_PIXEL_DIFFERENCE_KERNEL_H_

#include <cstdint>

namespace stereo_sgmp {

// For `count` pairs of pixels `base` plus the largest difference of their first three channels, at
// most 255. Pixels have 1, 3 or 4 interleaved channels.
void PixelDifferences(const std::uint8_t* from, const std::uint8_t* to, int channels, int count,
                      std::uint8_t base, std::uint8_t* differences);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_IMAGES_PIXEL_DIFFERENCE_KERNEL_H_
