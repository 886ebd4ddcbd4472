#ifndef STEREO_SGMP_REFINEMENT_MEDIAN_KERNEL_H_
#define STEREO_SGMP_REFINEMENT_MEDIAN_KERNEL_H_

#include <array>

namespace stereo_sgmp {

constexpr int kMedianRadius = 2;
constexpr int kMedianSide = 2 * kMedianRadius + 1;

// The 5x5 medians of the middle one of five rows of `width` pixels, whose ends are replicated.
// `scratch` has room for MedianScratch(width) values.
void MedianRow(const std::array<const float*, kMedianSide>& rows, int width, float* scratch,
               float* out);

int MedianScratch(int width);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_MEDIAN_KERNEL_H_
