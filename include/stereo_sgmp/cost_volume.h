#ifndef STEREO_SGMP_COST_VOLUME_H_
#define STEREO_SGMP_COST_VOLUME_H_

#include <cstddef>
#include <cstdint>
#include <vector>

namespace stereo_sgmp {

// Matching costs C_p(d) of every pixel p of the left image and every disparity d, 0 (match) to
// 255, made outside of the matcher, for instance by a network.
struct CostVolume {
  int width = 0;
  int height = 0;
  int disparities = 0;              // candidates d = min_disparity + index
  int min_disparity = 0;            // pixels
  std::vector<std::uint8_t> costs;  // [y][x][index], without padding

  const std::uint8_t* At(int y, int x) const {
    return costs.data() + (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                           static_cast<std::size_t>(x)) *
                              static_cast<std::size_t>(disparities);
  }
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_VOLUME_H_
