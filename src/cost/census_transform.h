#ifndef STEREO_SGMP_COST_CENSUS_TRANSFORM_H_
#define STEREO_SGMP_COST_CENSUS_TRANSFORM_H_

#include "cost/feature_planes.h"
#include "cost/padded_gray.h"

namespace stereo_sgmp {

// A window of (2 radius_x + 1) x (2 radius_y + 1) pixels, whose neighbours give a bit each.
struct CensusShape {
  int radius_x = 0;
  int radius_y = 0;

  constexpr int Bits() const { return (2 * radius_x + 1) * (2 * radius_y + 1) - 1; }
  constexpr int Bytes() const { return (Bits() + 7) / 8; }
};

// Census transform of row y (Zabih and Woodfill, ECCV 1994): bit i is 1 where neighbour i is
// brighter than the centre. Writes the bits, 8 to a plane, into planes [0, shape.Bytes()).
// Mirrored images get the same bits in the same order.
void CensusTransformRow(const PaddedGray& image, CensusShape shape, int y, FeaturePlanes* planes);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_CENSUS_TRANSFORM_H_
