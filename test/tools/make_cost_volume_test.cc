// Runs the program `make_cost_volume` as a user does, and `match` on what it wrote.
#include <algorithm>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "evaluation/dataset.h"
#include "io/cost_volume_file.h"
#include "io/file_io.h"
#include "io/temporary_folder.h"
#include "scene/generated_scene.h"
#include "tools/run_tool.h"

namespace stereo_sgmp {
namespace {

const cv::Size kSize(200, 120);
constexpr int kDisparities = 24;

class MakeCostVolume : public testing::Test {
 protected:
  MakeCostVolume() {
    SceneQuality quality;
    quality.vertical_offset = 0.6;  // the alignment has something to do
    const GeneratedScene generated =
        MakeScene(SceneKind::kSlantedPlane, kSize, kDisparities, quality, 1);
    StereoScene scene;
    scene.left = generated.left;
    scene.right = generated.right;
    scene.disparity = generated.disparity;
    scene.calibration = Calibration{generated.camera, kSize, kDisparities};
    SaveScene(Path("scene"), scene);
    files_before_ = folder_.Count();
  }

  std::string Path(const std::string& name) const { return folder_.Path(name); }
  std::string Pair() const { return Path("scene/im0.png") + " " + Path("scene/im1.png") + " "; }

  void Make(const std::string& flags) const {
    const ToolRun run = RunProgram(STEREO_SGMP_MAKE_COST_VOLUME, Pair() + flags);
    ASSERT_EQ(run.exit_code, 0) << flags << '\n' << run.err;
    EXPECT_EQ(run.err, "");
  }

  // The bytes of the raw disparities that `match` finds.
  std::string Matched(const std::string& flags) const {
    const ToolRun run =
        RunProgram(STEREO_SGMP_MATCH, Pair() + "--raw --disparity " + Path("d.pfm") + " " + flags);
    EXPECT_EQ(run.exit_code, 0) << flags << '\n' << run.err;
    return ReadFile(Path("d.pfm"));
  }

  void ExpectRefused(const std::string& flags, const std::string& message) const {
    const ToolRun run = RunProgram(STEREO_SGMP_MAKE_COST_VOLUME, flags);
    EXPECT_EQ(run.exit_code, 2) << flags << '\n' << run.err;
    EXPECT_NE(run.err.find(message), std::string::npos) << flags << '\n' << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(folder_.Count(), files_before_) << flags;
  }

  TemporaryFolder folder_;
  std::ptrdiff_t files_before_ = 0;
};

TEST_F(MakeCostVolume, WritesTheVolumeAndItsShape) {
  const std::string path = Path("c.bin");
  Make("--output " + path + " --min-disparity -2 --num-disparities 20");
  std::optional<CostVolume> volume = ReadCostVolumeShape(path);
  ASSERT_TRUE(volume);
  EXPECT_EQ(cv::Size(volume->width, volume->height), kSize);
  EXPECT_EQ(volume->disparities, 20);
  EXPECT_EQ(volume->min_disparity, -2);
  ReadCosts(path, &*volume);
  EXPECT_EQ(volume->At(40, 0)[10], 255) << "out of view";
  EXPECT_LT(*std::min_element(volume->costs.begin(), volume->costs.end()), 50);
}

TEST_F(MakeCostVolume, OfNccGivesWhatNccGivesWithEveryVariant) {
  Make("--output " + Path("c.bin") + " --calib " + Path("scene/calib.txt"));
  Make("--output " + Path("c.acrt") + " --num-disparities 24");
  for (const std::string flags : {" --variant sgm", " --variant epi", " --variant epv"}) {
    const std::string computed = Matched("--cost ncc --num-disparities 24" + flags);
    EXPECT_EQ(Matched("--cost " + Path("c.bin") + flags), computed) << flags;
  }
  const std::string computed = Matched("--cost ncc --num-disparities 24");
  EXPECT_EQ(Matched("--cost " + Path("c.acrt")), computed);
  EXPECT_NE(Matched("--cost census --num-disparities 24"), computed);
}

// The compact form of the mixed cost is one of its own, not the rounded full one.
TEST_F(MakeCostVolume, OfTheOtherCostsGivesWhatTheyGive) {
  std::ofstream(Path("full.yaml")) << "aggregation: {path_costs: full}\n";
  ++files_before_;
  const std::string full = " --variant sgm --options " + Path("full.yaml");
  const std::string compact = " --variant sgm";
  for (const auto& [cost, flags] :
       {std::pair("census", compact), std::pair("census", full), std::pair("mixed", full)}) {
    Make("--output " + Path("c.bin") + " --num-disparities 24 --cost " + cost);
    EXPECT_EQ(Matched("--cost " + Path("c.bin") + flags),
              Matched("--num-disparities 24 --cost " + std::string(cost) + flags));
  }
}

TEST_F(MakeCostVolume, RefusesWhatCannotBe) {
  const std::string output = " --output " + Path("c.bin");
  ExpectRefused(Pair(), "--output");
  ExpectRefused(Pair() + "--output " + Path("c.png"), ".bin or .acrt");
  ExpectRefused(Pair() + "--output " + Path("none/c.bin"), "does not exist");
  ExpectRefused(Pair() + output + " --num-disparities 0", "num_disparities");
  ExpectRefused(Pair() + output + " --cost " + Path("d.bin"), "--cost");
  ExpectRefused(Path("none.png") + " " + Path("scene/im1.png") + output, "no such file");
}

}  // namespace
}  // namespace stereo_sgmp
