#ifndef STEREO_SGMP_AGGREGATION_PATHS_H_
#define STEREO_SGMP_AGGREGATION_PATHS_H_

#include <array>

#include "prior/orientation_prior.h"

namespace stereo_sgmp {

// The forward sweep visits rows from top to bottom and pixels from left to right, and follows the
// paths whose predecessors it has met; the backward sweep mirrors it through the image centre and
// follows the opposite paths. Along the first two paths alone this is a four-direction SGM.
enum Path { kAcross = 0, kDown = 1, kDownRight = 2, kDownLeft = 3 };
inline constexpr int kPathsPerSweep = 4;

// Steps from p to q = p + r of the forward sweep.
inline constexpr std::array<PathStep, kPathsPerSweep> kForwardSteps{
    {{1, 0}, {0, 1}, {1, 1}, {-1, 1}}};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_AGGREGATION_PATHS_H_
