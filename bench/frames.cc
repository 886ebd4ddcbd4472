#include "frames.h"

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "stereo_sgmp/matcher.h"
#include "stereo_sgmp/presets.h"

namespace stereo_sgmp {
namespace {

class OurFrame : public Subject {
 public:
  OurFrame(const BenchPair& pair, const Options& options) : pair_(pair), matcher_(options) {}
  void Run() override { matcher_.Match(pair_.left, pair_.right, &result_); }
  int WarmUpRuns() const override { return 6; }  // frames over which a Matcher learns the rig
  std::vector<StageTime> Stages() const override { return result_.statistics.stages; }

 private:
  const BenchPair& pair_;
  Matcher matcher_;
  MatchResult result_;
};

// OpenCV's conversion to gray is not timed.
class OpenCvFrame : public Subject {
 public:
  OpenCvFrame(const BenchPair& pair, int mode) {
    cv::cvtColor(pair.left, left_, cv::COLOR_BGR2GRAY);
    cv::cvtColor(pair.right, right_, cv::COLOR_BGR2GRAY);
    constexpr int kBlock = 3;
    const int disparities = (pair.disparities + 15) / 16 * 16;
    matcher_ = cv::StereoSGBM::create(0, disparities, kBlock, 8 * kBlock * kBlock,
                                      32 * kBlock * kBlock, 1, 63, 10, 100, 32, mode);
  }
  void Run() override { matcher_->compute(left_, right_, disparity_); }

 private:
  cv::Mat left_;
  cv::Mat right_;
  cv::Ptr<cv::StereoSGBM> matcher_;
  cv::Mat disparity_;
};

SubjectEntry Ours(const std::string& name, const Options& options,
                  SimdTargets targets = SimdTargets::kAll) {
  const auto make = [options](const BenchPair& pair, int threads) {
    Options of_pair = options;
    of_pair.num_disparities = pair.disparities;
    of_pair.threads = threads;
    return std::make_unique<OurFrame>(pair, of_pair);
  };
  return {"frame/" + name, make, targets};
}

SubjectEntry OpenCv(const std::string& name, int mode) {
  const auto make = [mode](const BenchPair& pair, int) {
    return std::make_unique<OpenCvFrame>(pair, mode);
  };
  return {"opencv/" + name, make};
}

}  // namespace

std::vector<SubjectEntry> FrameSubjects() {
  std::vector<SubjectEntry> subjects;
  for (const std::string& preset : PresetNames()) {
    subjects.push_back(Ours(preset, PresetOptions(preset)));
  }
  subjects.push_back(Ours("default_avx2", Options(), SimdTargets::kUpToAvx2));
  Options lean;
  lean.memory_limit = 1000;
  subjects.push_back(Ours("default_lean", lean));
  Options epi;
  epi.prior.variant = Variant::kEpi;
  subjects.push_back(Ours("default_epi", epi));
  Options sgm;
  sgm.prior.variant = Variant::kSgm;
  subjects.push_back(Ours("default_sgm", sgm));
  sgm.cost.kind = CostKind::kCensus;
  subjects.push_back(Ours("census_sgm", sgm));
  subjects.push_back(OpenCv("sgbm_3way", cv::StereoSGBM::MODE_SGBM_3WAY));
  subjects.push_back(OpenCv("sgbm", cv::StereoSGBM::MODE_SGBM));
  subjects.push_back(OpenCv("hh4", cv::StereoSGBM::MODE_HH4));
  subjects.push_back(OpenCv("hh", cv::StereoSGBM::MODE_HH));
  return subjects;
}

}  // namespace stereo_sgmp
