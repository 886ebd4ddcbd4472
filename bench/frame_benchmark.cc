// Times whole frames of the matcher beside OpenCV's StereoSGBM, in one process. Usage:
//   frame_benchmark LEFT RIGHT WIDTH HEIGHT DISPARITIES THREADS [--benchmark_...]
// The pair is resized to the size asked for. With
//   --benchmark_repetitions=7 --benchmark_enable_random_interleaving=true
// both are run in turns, so that their ratio holds on a noisy machine.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "io/image.h"
#include "stereo_sgmp/matcher.h"
#include "stereo_sgmp/presets.h"

namespace stereo_sgmp {
namespace {

// Frames over which a Matcher learns the rig.
constexpr int kWarmUpFrames = 6;

struct Case {
  cv::Mat left;
  cv::Mat right;
  int disparities = 0;
  int threads = 0;
};

void SetCounters(const Case& input, benchmark::State* state) {
  const double evaluations =
      static_cast<double>(input.left.total()) * input.disparities * 1e-6;  // MDE
  state->counters["MDE/s"] =
      benchmark::Counter(evaluations, benchmark::Counter::kIsIterationInvariantRate);
}

void OurFrame(benchmark::State& state, const Case& input, const Options& options) {
  Matcher matcher(options);
  MatchResult result;
  for (int i = 0; i < kWarmUpFrames; ++i) matcher.Match(input.left, input.right, &result);
  for (auto _ : state) matcher.Match(input.left, input.right, &result);
  SetCounters(input, &state);
}

void OpenCvFrame(benchmark::State& state, const Case& input, int mode) {
  cv::setNumThreads(input.threads);
  cv::Mat left;
  cv::Mat right;
  cv::cvtColor(input.left, left, cv::COLOR_BGR2GRAY);
  cv::cvtColor(input.right, right, cv::COLOR_BGR2GRAY);
  constexpr int kBlock = 3;
  const int disparities = (input.disparities + 15) / 16 * 16;
  const auto matcher = cv::StereoSGBM::create(0, disparities, kBlock, 8 * kBlock * kBlock,
                                              32 * kBlock * kBlock, 1, 63, 10, 100, 32, mode);
  cv::Mat disparity;
  matcher->compute(left, right, disparity);
  for (auto _ : state) matcher->compute(left, right, disparity);
  SetCounters(input, &state);
}

void RegisterOurs(const std::string& name, const Case& input, Options options) {
  options.num_disparities = input.disparities;
  options.threads = input.threads;
  benchmark::RegisterBenchmark(name.c_str(), OurFrame, input, options)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

void RegisterOpenCv(const std::string& name, const Case& input, int mode) {
  benchmark::RegisterBenchmark(name.c_str(), OpenCvFrame, input, mode)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

void RegisterAll(const Case& input) {
  for (const std::string& preset : PresetNames()) {
    RegisterOurs(preset, input, PresetOptions(preset));
  }
  Options epi;
  epi.prior.variant = Variant::kEpi;
  RegisterOurs("default, EPi", input, epi);
  Options sgm;
  sgm.prior.variant = Variant::kSgm;
  RegisterOurs("default, no prior", input, sgm);
  sgm.cost.kind = CostKind::kCensus;
  RegisterOurs("census, no prior", input, sgm);
  RegisterOpenCv("MODE_SGBM_3WAY", input, cv::StereoSGBM::MODE_SGBM_3WAY);
  RegisterOpenCv("MODE_SGBM", input, cv::StereoSGBM::MODE_SGBM);
  RegisterOpenCv("MODE_HH4", input, cv::StereoSGBM::MODE_HH4);
  RegisterOpenCv("MODE_HH", input, cv::StereoSGBM::MODE_HH);
}

int Run(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc != 7) {
    std::fprintf(stderr, "usage: %s LEFT RIGHT WIDTH HEIGHT DISPARITIES THREADS\n", argv[0]);
    return 2;
  }
  const cv::Size size(std::atoi(argv[3]), std::atoi(argv[4]));
  Case input;
  cv::resize(LoadImage(argv[1]), input.left, size, 0, 0, cv::INTER_CUBIC);
  cv::resize(LoadImage(argv[2]), input.right, size, 0, 0, cv::INTER_CUBIC);
  input.disparities = std::atoi(argv[5]);
  input.threads = std::atoi(argv[6]);
  RegisterAll(input);
  benchmark::RunSpecifiedBenchmarks();
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
