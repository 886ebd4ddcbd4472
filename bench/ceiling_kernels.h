// Loops that do nothing but move or combine bytes, for the SIMD target of the machine.
#ifndef STEREO_SGMP_BENCH_CEILING_KERNELS_H_
#define STEREO_SGMP_BENCH_CEILING_KERNELS_H_

#include <cstddef>
#include <cstdint>

namespace stereo_sgmp {

// `bytes`: a multiple of 1024, at an address aligned to 64.
std::uint8_t ReadBytes(const std::uint8_t* from, std::size_t bytes);
void WriteBytes(std::uint8_t* to, std::size_t bytes);
void StreamBytes(std::uint8_t* to, std::size_t bytes);  // past the caches

// Alternates additions and minima of bytes in registers; `operations` counts those of single
// bytes. Returns how many were done, `operations` or a little more.
double AddAndMinBytes(double operations, std::uint8_t* result);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_BENCH_CEILING_KERNELS_H_
