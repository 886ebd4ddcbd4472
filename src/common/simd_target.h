#ifndef STEREO_SGMP_COMMON_SIMD_TARGET_H_
#define STEREO_SGMP_COMMON_SIMD_TARGET_H_

namespace stereo_sgmp {

// The instruction set that the kernels run with on this machine, by the name that Highway gives it,
// such as AVX2, or AVX3 for AVX-512.
const char* SimdTargetName();

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COMMON_SIMD_TARGET_H_
