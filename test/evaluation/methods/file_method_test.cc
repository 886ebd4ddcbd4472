#include "evaluation/methods/file_method.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>

#include <gtest/gtest.h>

#include "io/expect_message.h"
#include "io/image.h"
#include "io/pfm.h"
#include "io/temporary_folder.h"

namespace stereo_sgmp {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

StereoScene Desk() {
  StereoScene scene;
  scene.name = "desk";
  scene.left = cv::Mat::zeros(3, 4, CV_8U);
  return scene;
}

cv::Mat Map() { return (cv::Mat_<float>(3, 4) << 9, kInfinity, 5, 5, 6, 6, 6, 6, 7, 7, 7, 7); }

class FileMethodTest : public testing::Test {
 protected:
  FileMethodTest() { std::filesystem::create_directories(Path("desk")); }

  std::string Path(const std::string& name) const { return folder_.Path("theirs/" + name); }
  FileMethod Method() const { return FileMethod(folder_.Path("theirs")); }

  const TemporaryFolder folder_;
};

TEST_F(FileMethodTest, IsNamedAfterItsFolder) {
  EXPECT_EQ(Method().name(), "theirs");
  EXPECT_EQ(FileMethod(Path("")).name(), "theirs");
  ExpectInvalid([&] { FileMethod(folder_.Path("none")); }, "no such folder");
}

TEST_F(FileMethodTest, CountsHolesApartAndFillsThemFromTheBackground) {
  WritePfm(Path("desk.pfm"), Map());
  const MethodResult result = Method().Run(Desk(), 16);
  EXPECT_TRUE(std::isinf(result.raw.at<float>(0, 1)));
  EXPECT_EQ(result.dense.at<float>(0, 1), 5);
  EXPECT_EQ(result.dense.at<float>(0, 0), 9);
  EXPECT_EQ(result.valid.at<std::uint8_t>(0, 1), 0);
  EXPECT_EQ(result.valid.at<std::uint8_t>(0, 0), 255);
  EXPECT_EQ(result.confidence.at<float>(0, 1), 0);
  EXPECT_EQ(result.confidence.at<float>(0, 0), 1);
  EXPECT_TRUE(result.uncertainty.empty());
  EXPECT_TRUE(std::isnan(result.seconds));
}

TEST_F(FileMethodTest, ReadsPicturesAndSubmissions) {
  SaveImage(Path("desk.png"), cv::Mat(3, 4, CV_16U, cv::Scalar(640)));
  EXPECT_EQ(Method().Run(Desk(), 16).raw.at<float>(1, 1), 2.5);
  std::filesystem::remove(Path("desk.png"));
  WritePfm(Path("desk/disp0GT.pfm"), cv::Mat::ones(3, 4, CV_32F));
  WritePfm(Path("desk/disp0Best.pfm"), Map());
  EXPECT_EQ(Method().Run(Desk(), 16).raw.at<float>(2, 1), 7);
}

TEST_F(FileMethodTest, ScalesSmallerMapsUp) {
  WritePfm(Path("desk.pfm"), (cv::Mat_<float>(1, 2) << 3, kInfinity));
  const cv::Mat raw = Method().Run(Desk(), 16).raw;
  EXPECT_EQ(raw.size(), cv::Size(4, 3)) << "3 rows at half size are 1 or 2";
  EXPECT_EQ(raw.at<float>(2, 1), 6);
  EXPECT_TRUE(std::isinf(raw.at<float>(0, 2)));
}

TEST_F(FileMethodTest, SaysWhatIsMissingOrWrong) {
  EXPECT_NE(Method().Missing(Desk()).find("desk.pfm"), std::string::npos);
  WritePfm(Path("desk.pfm"), Map());
  EXPECT_EQ(Method().Missing(Desk()), "");
  WritePfm(Path("desk.pfm"), cv::Mat::ones(3, 8, CV_32F));
  ExpectInvalid([&] { Method().Run(Desk(), 16); }, "8 x 3");
  WritePfm(Path("desk.pfm"), cv::Mat::ones(3, 2, CV_32F));
  ExpectInvalid([&] { Method().Run(Desk(), 16); }, "2 x 3");
  WritePfm(Path("desk/disp0Best.pfm"), Map());
  ExpectInvalid([&] { Method().Missing(Desk()); }, "both");
}

}  // namespace
}  // namespace stereo_sgmp
