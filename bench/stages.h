// The stages of a frame of the default preset, each alone.
#ifndef STEREO_SGMP_BENCH_STAGES_H_
#define STEREO_SGMP_BENCH_STAGES_H_

#include <vector>

#include "subject.h"

namespace stereo_sgmp {

std::vector<SubjectEntry> StageSubjects();

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_BENCH_STAGES_H_
