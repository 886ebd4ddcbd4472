# Options of this package's own code; headers of other packages are system headers.
add_library(stereo_sgmp_compile_options INTERFACE)
target_compile_options(stereo_sgmp_compile_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion
  # The same bits on every SIMD target: no fused multiply-add behind the program's back.
  -ffp-contract=off
  # Functions of this library are not replaced from outside: they may be inlined.
  -fno-semantic-interposition)
# SIMD targets that Highway chooses from at run time: from SSE4 on; older processors take the
# plain one. Each target adds to the build time, with sanitizers minutes for some kernels. On Arm
# NEON: vectors of SVE can't stand in arrays, as the kernels have them.
set(STEREO_SGMP_OMIT_TARGETS "0" CACHE STRING "SIMD targets left out too: HWY_SSE4|HWY_AVX2 and so on")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "aarch64|arm64")
  target_compile_definitions(stereo_sgmp_compile_options INTERFACE
    "HWY_DISABLED_TARGETS=(HWY_SVE|HWY_SVE2|HWY_SVE_256|HWY_SVE2_128)")
else()
  target_compile_definitions(stereo_sgmp_compile_options INTERFACE
    "HWY_DISABLED_TARGETS=(HWY_SSSE3|${STEREO_SGMP_OMIT_TARGETS})")
endif()
if(STEREO_SGMP_WARNINGS_AS_ERRORS)
  target_compile_options(stereo_sgmp_compile_options INTERFACE -Werror)
endif()
# Of the programs around the library, which does the work: to optimize them with sanitizers takes
# three times as long as to compile them, and more than it saves when they run.
add_library(stereo_sgmp_program_options INTERFACE)
target_link_libraries(stereo_sgmp_program_options INTERFACE stereo_sgmp_compile_options)
if(STEREO_SGMP_SANITIZE)
  target_compile_options(stereo_sgmp_program_options INTERFACE -O0)
  add_compile_options(-fsanitize=${STEREO_SGMP_SANITIZE} -fno-omit-frame-pointer
                      -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${STEREO_SGMP_SANITIZE})
endif()
