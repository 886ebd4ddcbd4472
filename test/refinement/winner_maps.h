// Winner maps for tests.
#ifndef STEREO_SGMP_TEST_REFINEMENT_WINNER_MAPS_H_
#define STEREO_SGMP_TEST_REFINEMENT_WINNER_MAPS_H_

#include <cstdint>

#include "aggregation/winner_map.h"

namespace stereo_sgmp {

// Every pixel wins clearly at the index `winner`: cost 100, neighbours 200, second best 900, U 0.
// Right winners agree.
WinnerMap UniformWinnerMap(const VolumeShape& shape, std::uint16_t winner);

// What aggregated costs S(x, y, d) drawn at random would give; the same for the same seed.
WinnerMap RandomWinnerMap(const VolumeShape& shape, unsigned seed);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_TEST_REFINEMENT_WINNER_MAPS_H_
