// Runs the program `match` as a user does.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "evaluation/dataset.h"
#include "evaluation/metrics.h"
#include "io/file_io.h"
#include "io/image.h"
#include "io/pfm.h"
#include "io/temporary_folder.h"
#include "prior/manhattan/line_detector.h"
#include "scene/generated_scene.h"
#include "tools/run_tool.h"

namespace stereo_sgmp {
namespace {

const cv::Size kSize(240, 160);
constexpr int kDisparities = 32;

// A folder with a generated scene, and the program run in it.
class Match : public testing::Test {
 protected:
  Match() {
    const GeneratedScene generated =
        MakeScene(SceneKind::kFrontoParallel, kSize, kDisparities, {}, 1);
    scene_.left = generated.left;
    scene_.right = generated.right;
    scene_.disparity = generated.disparity;
    scene_.mask = generated.mask;
    scene_.calibration = Calibration{generated.camera, kSize, kDisparities};
    SaveScene(Path("scene"), scene_);
    files_before_ = folder_.Count();
  }

  std::string Path(const std::string& name) const { return folder_.Path(name); }
  std::string Pair() const { return Path("scene/im0.png") + " " + Path("scene/im1.png"); }
  std::string Output() const { return " --disparity " + Path("d.pfm"); }
  ToolRun Run(const std::string& arguments) const {
    return RunProgram(STEREO_SGMP_MATCH, arguments);
  }

  // A message of one line, the exit code of a wrong command line, and no file.
  void ExpectRefused(const std::string& arguments, const std::string& message) const {
    const ToolRun run = Run(arguments);
    EXPECT_EQ(run.exit_code, 2) << arguments << '\n' << run.err;
    EXPECT_NE(run.err.find(message), std::string::npos) << arguments << '\n' << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(folder_.Count(), files_before_) << arguments;
  }

  void ExpectRefusedPicture(const std::string& bytes, const std::string& message) const {
    WriteFile(Path("scene/bad.png"), bytes);
    ExpectRefused(Path("scene/bad.png") + " " + Path("scene/im1.png") + Output(), message);
    ExpectRefused(Path("scene/im0.png") + " " + Path("scene/bad.png") + Output(), message);
  }

  TemporaryFolder folder_;
  StereoScene scene_;
  std::ptrdiff_t files_before_ = 0;
};

TEST_F(Match, WritesEverythingAskedFor) {
  const ToolRun run = Run(Pair() + Output() + " --calib " + Path("scene/calib.txt") +
                          " --confidence " + Path("c.pfm") + " --color " + Path("c.png") +
                          " --cloud " + Path("c.ply") + " --prior-image " + Path("p.png") +
                          " --stats " + Path("s.json") + " --repeat 3 --threads 2");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(folder_.Count(), files_before_ + 6);
  EXPECT_EQ(LoadImage(Path("c.png")).size(), kSize);
  EXPECT_EQ(LoadImage(Path("p.png")).size(), kSize);
  EXPECT_EQ(ReadFile(Path("c.ply")).substr(0, 4), "ply\n");
  double min = 0;
  double max = 0;
  cv::minMaxLoc(ReadPfm(Path("c.pfm")), &min, &max);
  EXPECT_GE(min, 0);
  EXPECT_LE(max, 1);
  const std::string json = ReadFile(Path("s.json"));
  for (const char* key :
       {"frame_ms", "first_frame_ms", "stages_ms", "peak_rss_mb", "variant", "variant_note",
        "planes", "density", "reasons", "left_right", "alignment"}) {
    EXPECT_NE(json.find("\"" + std::string(key) + "\": "), std::string::npos) << json;
  }
}

TEST_F(Match, FindsTheDisparities) {
  ASSERT_EQ(Run(Pair() + Output() + " --num-disparities 32").exit_code, 0);
  const cv::Mat filtered = ReadPfm(Path("d.pfm"));
  const cv::Mat valid = filtered <= kDisparities;
  EXPECT_GT(cv::countNonZero(valid), kSize.area() / 2);
  EXPECT_EQ(cv::countNonZero(valid) + cv::countNonZero(filtered == INFINITY), kSize.area())
      << "invalid pixels are inf";
  const cv::Mat evaluated = EvaluatedPixels(scene_.disparity, scene_.mask);
  EXPECT_LT(BadPercent(filtered, scene_.disparity, evaluated & valid, {1.0}), 5);
  for (const char* kind : {" --dense", " --raw"}) {
    ASSERT_EQ(Run(Pair() + Output() + " --num-disparities 32" + kind).exit_code, 0);
    EXPECT_EQ(cv::countNonZero(ReadPfm(Path("d.pfm")) <= kDisparities), kSize.area()) << kind;
  }
}

TEST_F(Match, AppliesPresetThenFileThenFlags) {
  const std::string options = folder_.Write("o.yaml", "num_disparities: 24\nmin_disparity: 3\n");
  const std::string run =
      Pair() + Output() + " --stats " + Path("s.json") + " --options " + options;
  const auto range = [&](const std::string& flags) {
    EXPECT_EQ(Run(run + flags).exit_code, 0) << flags;
    const std::string json = ReadFile(Path("s.json"));
    const std::size_t begin = json.find("\"min_disparity\"");
    return json.substr(begin, json.find("\"frames\"") - begin);
  };
  EXPECT_EQ(range(""), "\"min_disparity\": 3,\n  \"num_disparities\": 24,\n  ");
  EXPECT_EQ(range(" --preset paper --num-disparities 16 --min-disparity -2"),
            "\"min_disparity\": -2,\n  \"num_disparities\": 16,\n  ");
}

TEST_F(Match, TakesEveryVariantAndCost) {
  for (const char* flags : {"--variant sgm --cost ncc", "--variant epi --cost census",
                            "--variant epv --cost mixed", "--preset quality", "--preset paper"}) {
    const ToolRun run = Run(Pair() + Output() + " --num-disparities 32 " + flags);
    EXPECT_EQ(run.exit_code, 0) << flags << run.err;
  }
}

TEST_F(Match, SaysWhichPriorWasUsed) {
  const std::string run = Pair() + Output() + " --calib " + Path("scene/calib.txt") +
                          " --num-disparities 32 --stats " + Path("s.json");
  const auto expect_variant = [&](const char* variant) {
    const std::string json = ReadFile(Path("s.json"));
    EXPECT_NE(json.find("\"variant\": \"" + std::string(variant) + "\""), std::string::npos)
        << json;
  };
  EXPECT_EQ(Run(run + " --variant epi").err, "");
  expect_variant("epi");
  if (!kHasLineDetector) GTEST_SKIP();
  const ToolRun without_lines = Run(run + " --variant mw");
  EXPECT_EQ(without_lines.exit_code, 0) << without_lines.err;
  EXPECT_EQ(without_lines.err,
            "match: the lines of the image show no three orthogonal directions; the prior is that "
            "of epv\n");
  expect_variant("epv");
}

TEST_F(Match, ExplainsItself) {
  const ToolRun run = Run("--help");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.out.find("Examples"), std::string::npos);
  EXPECT_NE(run.out.find("--num-disparities"), std::string::npos);
}

TEST_F(Match, RefusesWrongCommandLines) {
  ExpectRefused("", "left is required");
  ExpectRefused(Pair(), "--disparity");
  ExpectRefused(Pair() + Output() + " --no-such-flag", "--no-such-flag");
  ExpectRefused(Pair() + Output() + " --variant gn", "sgm,epi,epv,gs,gp,gni,gnv,mw");
  ExpectRefused(Pair() + Output() + " --cost price", "price");
  ExpectRefused(Pair() + Output() + " --preset best", "best");
  ExpectRefused(Pair() + Output() + " --repeat 0", "--repeat");
  ExpectRefused(Pair() + Output() + " --dense --raw", "--raw");
  ExpectRefused(Pair() + Output() + " --cloud " + Path("c.ply"), "--calib");
  ExpectRefused(Pair() + Output() + " --options " + Path("none.yaml"), "none.yaml");
}

TEST_F(Match, NamesWhatAVariantNeeds) {
  const std::string flags = Pair() + Output() + " --num-disparities 32 --variant ";
  ExpectRefused(flags + "gs", "variant gs needs a disparity surface");
  ExpectRefused(flags + "gp", "variant gp needs a disparity surface");
  ExpectRefused(flags + "gni", "variant gni needs a normal map");
  ExpectRefused(flags + "gnv", "variant gnv needs a normal map");
  ExpectRefused(flags + "mw", "variant mw needs the camera");
}

TEST_F(Match, RefusesWrongRanges) {
  for (const char* flags :
       {"--num-disparities 0", "--num-disparities -5", "--num-disparities 4000",
        "--num-disparities 1000", "--min-disparity 100000", "--min-disparity x", "--threads -3"}) {
    ExpectRefused(Pair() + Output() + " " + flags, "");
  }
}

TEST_F(Match, RefusesPicturesThatAreNone) {
  ExpectRefused(Path("none.png") + " " + Path("scene/im1.png") + Output(), "no such file");
  ExpectRefused(Path("scene") + " " + Path("scene/im1.png") + Output(), "folder");
  ExpectRefusedPicture("", "empty");
  ExpectRefusedPicture("This is text.", "not a picture");
  const std::string whole = ReadFile(Path("scene/im0.png"));
  ExpectRefusedPicture(whole.substr(0, whole.size() / 2), "truncated");
}

TEST_F(Match, RefusesPairsThatDoNotFit) {
  SaveImage(Path("scene/small.png"), scene_.right.colRange(0, 100));
  ExpectRefused(Path("scene/im0.png") + " " + Path("scene/small.png") + Output(), "100 x 160");
  SaveImage(Path("scene/gray.png"), cv::Mat(kSize, CV_8U, cv::Scalar(7)));
  ExpectRefused(Path("scene/im0.png") + " " + Path("scene/gray.png") + Output(), "gray.png");
}

TEST_F(Match, RefusesWrongCalibrations) {
  const std::string with_calib = Pair() + Output() + " --calib ";
  ExpectRefused(with_calib + Path("none.txt"), "no such file");
  WriteFile(Path("scene/calib.txt"), "baseline=3\n");
  ExpectRefused(with_calib + Path("scene/calib.txt"), "cam0");
  Calibration other = *scene_.calibration;
  other.size = cv::Size(99, 88);
  WriteCalibration(Path("scene/calib.txt"), other);
  ExpectRefused(with_calib + Path("scene/calib.txt"), "99 x 88");
}

TEST_F(Match, FindsOutBeforeItStartsThatItCannotWrite) {
  ExpectRefused(Pair() + " --disparity " + Path("none/d.pfm"), "does not exist");
  ExpectRefused(Pair() + " --disparity " + Path("scene"), "folder");
  ExpectRefused(Pair() + Output() + " --color " + Path("c.xyz"), ".xyz");
}

}  // namespace
}  // namespace stereo_sgmp
