// Times whole frames, their stages and OpenCV's StereoSGBM in turns, in one process. Usage:
//   stereo_benchmark LEFT RIGHT WIDTH HEIGHT DISPARITIES [--benchmark_...]
// The pair is resized to the size asked for. Benchmarks are named KIND/SUBJECT/THREADS; each
// repetition is one run of a warm subject, so that with
//   --benchmark_repetitions=7 --benchmark_enable_random_interleaving=true
// ratios hold on a noisy machine. first/KIND/SUBJECT/THREADS is the first run in cold memory, and
// what it occupies: a single one of them in a process, selected by --benchmark_filter.
#include <benchmark/benchmark.h>
#include <hwy/highway.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <opencv2/imgproc.hpp>
#include <string>

#include "frames.h"
#include "io/image.h"
#include "stages.h"

namespace stereo_sgmp {
namespace {

// Lets the subjects of this package see part of the machine's SIMD targets while it lives.
class TargetScope {
 public:
  explicit TargetScope(SimdTargets targets) {
    if (targets == SimdTargets::kAll) return;
#if HWY_ARCH_X86
    Set(hwy::SupportedTargets() & ~(HWY_AVX2 - 1));  // lower bits are better targets
#endif
  }
  ~TargetScope() { Set(0); }
  TargetScope(const TargetScope&) = delete;
  TargetScope& operator=(const TargetScope&) = delete;

 private:
  static void Set(std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

// A line of /proc/self/status, bytes; 0 where there is none.
std::size_t StatusBytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::size_t kilobytes = 0;
    if (word == key + ":" && status >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

class SubjectBenchmark {
 public:
  SubjectBenchmark(const BenchPair& pair, SubjectEntry entry, int threads)
      : pair_(pair), entry_(std::move(entry)), threads_(threads) {}

  void Warm(benchmark::State& state) {
    cv::setNumThreads(threads_);
    const TargetScope targets(entry_.targets);
    if (!subject_) {
      subject_ = entry_.make(pair_, threads_);
      for (int i = 0; i < subject_->WarmUpRuns(); ++i) subject_->Run();
    }
    for (auto _ : state) subject_->Run();
    for (const StageTime& stage : subject_->Stages()) state.counters["ms " + stage.name] = stage.ms;
    SetRate(&state);
  }

  void First(benchmark::State& state) {
    cv::setNumThreads(threads_);
    const TargetScope targets(entry_.targets);
    const std::size_t before = StatusBytes("VmRSS");
    for (auto _ : state) {
      subject_ = entry_.make(pair_, threads_);
      subject_->Run();
    }
    state.counters["peak_bytes"] = static_cast<double>(StatusBytes("VmHWM") - before);
    SetRate(&state);
  }

 private:
  void SetRate(benchmark::State* state) const {
    const double evaluations = static_cast<double>(pair_.left.total()) * pair_.disparities;
    state->counters["MDE/s"] =
        benchmark::Counter(evaluations * 1e-6, benchmark::Counter::kIsIterationInvariantRate);
  }

  const BenchPair& pair_;
  SubjectEntry entry_;
  int threads_;
  std::unique_ptr<Subject> subject_;
};

void Register(const std::string& name, std::function<void(benchmark::State&)> run) {
  benchmark::RegisterBenchmark(name.c_str(), std::move(run))
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime()
      ->Iterations(1);
}

void RegisterAll(const BenchPair& pair, const std::vector<SubjectEntry>& subjects) {
  for (const SubjectEntry& entry : subjects) {
    for (const int threads : {1, 2}) {
      const auto subject = std::make_shared<SubjectBenchmark>(pair, entry, threads);
      const std::string name = entry.name + "/" + std::to_string(threads);
      Register(name, [subject](benchmark::State& state) { subject->Warm(state); });
      Register("first/" + name, [subject](benchmark::State& state) { subject->First(state); });
    }
  }
}

cv::Mat LoadResized(const std::string& path, cv::Size size) {
  cv::Mat image = To8Bit(LoadImage(path));
  if (image.channels() == 1) cv::cvtColor(image, image, cv::COLOR_GRAY2BGR);
  if (image.channels() == 4) cv::cvtColor(image, image, cv::COLOR_BGRA2BGR);
  cv::resize(image, image, size, 0, 0, cv::INTER_AREA);
  return image;
}

int Run(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc != 6) {
    std::fprintf(stderr, "usage: %s LEFT RIGHT WIDTH HEIGHT DISPARITIES [--benchmark_...]\n",
                 argv[0]);
    return 2;
  }
  const cv::Size size(std::atoi(argv[3]), std::atoi(argv[4]));
  BenchPair pair;
  pair.left = LoadResized(argv[1], size);
  pair.right = LoadResized(argv[2], size);
  pair.disparities = std::atoi(argv[5]);
  RegisterAll(pair, FrameSubjects());
  RegisterAll(pair, StageSubjects());
  benchmark::AddCustomContext("opencv", CV_VERSION);
  benchmark::AddCustomContext("compiler", __VERSION__);
  benchmark::AddCustomContext("simd_target",
                              hwy::TargetName(hwy::SupportedTargets() & -hwy::SupportedTargets()));
  benchmark::RunSpecifiedBenchmarks();
  benchmark::ClearRegisteredBenchmarks();  // before the pair
  return 0;
}

}  // namespace
}  // namespace stereo_sgmp

int main(int argc, char** argv) {
  try {
    return stereo_sgmp::Run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
