// Runs the program `match` with what may be known of a pair beyond its images.
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "evaluation/dataset.h"
#include "io/cost_volume_file.h"
#include "io/file_io.h"
#include "io/image.h"
#include "io/pfm.h"
#include "io/temporary_folder.h"
#include "scene/generated_scene.h"
#include "tools/run_tool.h"

namespace stereo_sgmp {
namespace {

const cv::Size kSize(96, 48);
constexpr int kDisparities = 16;

class MatchInputsTest : public testing::Test {
 protected:
  MatchInputsTest() {
    const GeneratedScene generated =
        MakeScene(SceneKind::kSlantedPlane, kSize, kDisparities, {}, 1);
    StereoScene scene;
    scene.left = generated.left;
    scene.right = generated.right;
    scene.disparity = generated.disparity;
    scene.calibration = Calibration{generated.camera, kSize, kDisparities};
    SaveScene(Path("scene"), scene);
  }

  std::string Path(const std::string& name) const { return folder_.Path(name); }
  ToolRun Run(const std::string& flags) const {
    return RunProgram(STEREO_SGMP_MATCH, Path("scene/im0.png") + " " + Path("scene/im1.png") +
                                             " --disparity " + Path("d.pfm") + " " + flags);
  }
  std::string Calib() const { return " --calib " + Path("scene/calib.txt"); }

  void ExpectTaken(const std::string& flags) const {
    const ToolRun run = Run(flags);
    EXPECT_EQ(run.exit_code, 0) << flags << '\n' << run.err;
    EXPECT_EQ(run.err, "");
  }

  void ExpectRefused(const std::string& flags, const std::string& message) const {
    const ToolRun run = Run(flags);
    EXPECT_EQ(run.exit_code, 2) << flags << '\n' << run.err;
    EXPECT_NE(run.err.find(message), std::string::npos) << flags << '\n' << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }

  TemporaryFolder folder_;
};

TEST_F(MatchInputsTest, TakesSurfacesOfAllFormats) {
  const std::string gs = "--num-disparities 16 --variant gs --prior-surface ";
  ExpectTaken(gs + Path("scene/disp0GT.pfm"));
  SaveImage(Path("8.png"), cv::Mat(kSize, CV_8U, cv::Scalar(32)));
  ExpectTaken(gs + Path("8.png") + " --prior-scale 4");
  SaveImage(Path("16.png"), cv::Mat(kSize, CV_16U, cv::Scalar(2048)));
  ExpectTaken(gs + Path("16.png"));
  ExpectTaken(gs + Path("16.png") + " --prior-depth" + Calib());
}

TEST_F(MatchInputsTest, RefusesSurfacesThatDoNotFit) {
  const std::string surface = "--num-disparities 16 --prior-surface ";
  const std::string good = surface + Path("scene/disp0GT.pfm");
  ExpectRefused(surface + Path("none.pfm"), "no such file");
  ExpectRefused(surface + Path("scene"), "folder");
  ExpectRefused(surface + folder_.Write("e.pfm", ""), "empty");
  WritePfm(Path("s.pfm"), cv::Mat(8, 9, CV_32F, cv::Scalar(1)));
  ExpectRefused(surface + Path("s.pfm"), "s.pfm: 9 x 8 pixels, but the images have 96 x 48");
  ExpectRefused(good + " --prior-scale -1", "--prior-scale");
  ExpectRefused(good + " --prior-scale 0", "--prior-scale");
  ExpectRefused(good + " --prior-scale nan", "scale of its disparities is nan");
  ExpectRefused(good + " --prior-depth", "--calib");
  ExpectRefused("--num-disparities 16 --prior-scale 2", "--prior-surface");
  ExpectRefused(good + " --prior-depth --prior-scale 2" + Calib(), "--prior-");
}

TEST_F(MatchInputsTest, RefusesNormalsThatDoNotFit) {
  const std::string normals = "--num-disparities 16 --normals ";
  ExpectRefused(normals + Path("scene/disp0GT.pfm"), "one channel found, three");
  WritePfm(Path("s.pfm"), cv::Mat(8, 9, CV_32FC3, cv::Scalar(0, 0, -1)));
  ExpectRefused(normals + Path("s.pfm"), "s.pfm: 9 x 8 pixels, but the images have 96 x 48");
  WritePfm(Path("l.pfm"), cv::Mat(kSize, CV_32FC3, cv::Scalar(0, 0, -2)));
  ExpectRefused(normals + Path("l.pfm"), "length 2");
}

TEST_F(MatchInputsTest, TakesKnownDiscontinuities) {
  WritePfm(Path("n.pfm"), cv::Mat(kSize, CV_32FC3, cv::Scalar(0, 0, -1)));
  const std::string normals = "--variant gnv" + Calib() + " --normals " + Path("n.pfm");
  const std::string flag = " --discontinuities ";
  SaveImage(Path("m.png"), cv::Mat(kSize, CV_8U, cv::Scalar(0)));
  ExpectTaken(normals + flag + Path("m.png"));
  SaveImage(Path("s.png"), cv::Mat(8, 9, CV_8U, cv::Scalar(0)));
  ExpectRefused(normals + flag + Path("s.png"), "9 x 8 pixels, but the images have 96 x 48");
  SaveImage(Path("c.png"), cv::Mat(kSize, CV_8UC3, cv::Scalar(0)));
  ExpectRefused(normals + flag + Path("c.png"), "3 channels of 8 bit");
  ExpectRefused("--variant sgm" + flag + Path("m.png"), "--normals");
}

TEST_F(MatchInputsTest, RefusesCostVolumesThatAreNone) {
  const std::string bytes(static_cast<std::size_t>(kSize.area() * kDisparities * 4), '\0');
  const auto refuse = [&](const std::string& content, const std::string& message) {
    ExpectRefused("--num-disparities 16 --cost " + folder_.Write("c.bin", content), message);
  };
  ExpectRefused("--cost " + Path("none.bin"), "no such file");
  ExpectRefused("--cost " + Path("costs.dat"), ".bin or .acrt");
  refuse("", "0 bytes, but 96 x 48 pixels and 16 disparities need 294912");
  refuse(bytes.substr(4), "truncated");
  refuse(bytes + bytes, "one of 32 disparities");
  std::string infinite = bytes;
  infinite.replace(8, 4, std::string("\0\0\x80\x7F", 4));
  refuse(infinite, "x 2, y 0, disparity index 0 is inf");
  folder_.Write("c.bin.shape", "96 48 bad");
  refuse(bytes, "c.bin.shape");
}

TEST_F(MatchInputsTest, TakesTheRangeOfTheCostVolume) {
  CostVolume volume;
  volume.width = kSize.width;
  volume.height = kSize.height;
  volume.disparities = 9;
  volume.min_disparity = 5;
  volume.costs.assign(static_cast<std::size_t>(kSize.area() * 9), 100);
  for (std::size_t i = 3; i < volume.costs.size(); i += 9) volume.costs[i] = 0;
  WriteCostVolume(Path("c.acrt"), volume);
  ExpectTaken("--raw --variant sgm --cost " + Path("c.acrt") + Calib());
  EXPECT_EQ(cv::norm(ReadPfm(Path("d.pfm")) - 8.0, cv::NORM_INF), 0.0);
  ExpectRefused("--num-disparities 16 --cost " + Path("c.acrt"), "num_disparities to 9");
  ExpectRefused("--min-disparity 0 --cost " + Path("c.acrt"), "min_disparity to 5");
}

}  // namespace
}  // namespace stereo_sgmp
