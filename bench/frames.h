// Whole frames: the presets of this package and the modes of OpenCV's StereoSGBM.
#ifndef STEREO_SGMP_BENCH_FRAMES_H_
#define STEREO_SGMP_BENCH_FRAMES_H_

#include <vector>

#include "subject.h"

namespace stereo_sgmp {

std::vector<SubjectEntry> FrameSubjects();

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_BENCH_FRAMES_H_
