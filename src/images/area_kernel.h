#ifndef STEREO_SGMP_IMAGES_AREA_KERNEL_H_
#define STEREO_SGMP_IMAGES_AREA_KERNEL_H_

#include <cstdint>
#include <vector>

namespace stereo_sgmp {

// Values that SumTaps reads beyond the taps of the last pixel, and writes beyond that pixel.
constexpr int kTapOverrun = 1;

// The pixels of a shrunk row of 1 or 3 interleaved channels: `taps` neighbours each of `source`,
// from `first` on, times their weights, added up in order, as floats round.
void SumTaps(const float* source, int channels, const std::vector<int>& first, const float* weights,
             int taps, float* shrunk);

// sums += weight * values
void AddWeighted(const float* values, float weight, int count, float* sums);

void BytesToFloats(const std::uint8_t* bytes, int count, float* floats);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_IMAGES_AREA_KERNEL_H_
