// What the benchmark times: one call at a time, so that subjects can take turns.
#ifndef STEREO_SGMP_BENCH_SUBJECT_H_
#define STEREO_SGMP_BENCH_SUBJECT_H_

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "stereo_sgmp/match_result.h"

namespace stereo_sgmp {

// A stereo pair and the range to search.
struct BenchPair {
  cv::Mat left;   // CV_8UC3
  cv::Mat right;  // CV_8UC3
  int disparities = 0;
};

// Something that is run again and again on one pair, keeping its buffers.
class Subject {
 public:
  virtual ~Subject() = default;
  virtual void Run() = 0;
  // Calls of Run until times are steady: buffers touched, the rig learnt.
  virtual int WarmUpRuns() const { return 1; }
  // The parts of the last Run, where it knows them.
  virtual std::vector<StageTime> Stages() const { return {}; }
};

enum class SimdTargets {
  kAll,
  kUpToAvx2,  // the same where the machine has nothing better
};

struct SubjectEntry {
  std::string name;
  std::function<std::unique_ptr<Subject>(const BenchPair& pair, int threads)> make;
  SimdTargets targets = SimdTargets::kAll;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_BENCH_SUBJECT_H_
