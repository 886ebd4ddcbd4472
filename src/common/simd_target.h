#ifndef STEREO_SGMP_COMMON_SIMD_TARGET_H_
#define STEREO_SGMP_COMMON_SIMD_TARGET_H_

namespace stereo_sgmp {

// The name of the instruction set that the kernels run with on this machine, such as AVX2.
const char* SimdTargetName();

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COMMON_SIMD_TARGET_H_
