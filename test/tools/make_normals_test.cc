// Runs the program `make_normals` as a user does.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "io/calib.h"
#include "io/image.h"
#include "io/normals_file.h"
#include "io/pfm.h"
#include "io/temporary_folder.h"
#include "tools/run_tool.h"

namespace stereo_sgmp {
namespace {

const cv::Size kSize(20, 12);

class MakeNormals : public testing::Test {
 protected:
  MakeNormals() {
    Calibration calibration;
    calibration.camera = {100.0, 9.0, 5.0, 2.0, 0.1};
    calibration.size = kSize;
    WriteCalibration(Path("calib.txt"), calibration);
    WritePfm(Path("d.pfm"), cv::Mat(kSize, CV_32F, cv::Scalar(8)));
    files_before_ = folder_.Count();
  }

  std::string Path(const std::string& name) const { return folder_.Path(name); }
  ToolRun Run(const std::string& flags) const {
    return RunProgram(STEREO_SGMP_MAKE_NORMALS, flags + " --output " + Path("n.pfm"));
  }
  std::string Calib() const { return " --calib " + Path("calib.txt"); }

  void ExpectFacesTheCamera(const std::string& flags) const {
    const ToolRun run = Run(flags + Calib());
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const cv::Mat normals = ReadNormals(Path("n.pfm"));
    EXPECT_EQ(normals.size(), kSize);
    EXPECT_EQ(cv::norm(normals, cv::Mat(kSize, CV_32FC3, cv::Scalar(0, 0, -1)), cv::NORM_INF), 0);
  }

  void ExpectRefused(const std::string& flags, const std::string& message) const {
    const ToolRun run = Run(flags);
    EXPECT_EQ(run.exit_code, 2) << flags << '\n' << run.err;
    EXPECT_NE(run.err.find(message), std::string::npos) << flags << '\n' << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_EQ(folder_.Count(), files_before_) << flags;
  }

  TemporaryFolder folder_;
  std::ptrdiff_t files_before_ = 0;
};

TEST_F(MakeNormals, TakesDisparitiesAndDepths) {
  ExpectFacesTheCamera(Path("d.pfm"));
  SaveImage(Path("d.png"), cv::Mat(kSize, CV_8U, cv::Scalar(20)));
  ExpectFacesTheCamera(Path("d.png") + " --scale 4");
  SaveImage(Path("z.png"), cv::Mat(kSize, CV_16U, cv::Scalar(1500)));
  ExpectFacesTheCamera(Path("z.png") + " --depth");
}

TEST_F(MakeNormals, FollowsTheSlopeInSpace) {
  StereoCamera camera = ReadCalibration(Path("calib.txt")).camera;
  const DisparityPlane ground = camera.ToDisparity({{0.0, -1.0, 0.0}, -0.5});
  cv::Mat map(kSize, CV_32F);
  for (int y = 0; y < map.rows; ++y) map.row(y).setTo(ground.At(0, y));
  WritePfm(Path("ground.pfm"), map);
  ASSERT_EQ(Run(Path("ground.pfm") + Calib()).exit_code, 0);
  const cv::Vec3f normal = ReadNormals(Path("n.pfm")).at<cv::Vec3f>(10, 3);
  EXPECT_LT(cv::norm(normal - cv::Vec3f(0, -1, 0)), 1e-4);
}

TEST_F(MakeNormals, RefusesWhatCannotBe) {
  ExpectRefused(Path("d.pfm"), "--calib is required");
  ExpectRefused(Path("none.pfm") + Calib(), "no such file");
  ExpectRefused(Path("d.pfm") + " --calib " + Path("none.txt"), "no such file");
  ExpectRefused(Path("d.pfm") + Calib() + " --scale -1", "--scale");
  ExpectRefused(Path("d.pfm") + Calib() + " --scale 0", "--scale");
  ExpectRefused(Path("d.pfm") + Calib() + " --scale nan", "scale");
  ExpectRefused(Path("d.pfm") + Calib() + " --scale 2 --depth", "--depth");
  Calibration other = ReadCalibration(Path("calib.txt"));
  other.size = cv::Size(99, 88);
  WriteCalibration(Path("calib.txt"), other);
  ExpectRefused(Path("d.pfm") + Calib(), "99 x 88");
}

}  // namespace
}  // namespace stereo_sgmp
