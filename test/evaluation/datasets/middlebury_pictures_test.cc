#include "evaluation/datasets/middlebury_pictures.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>

#include <gtest/gtest.h>

#include "evaluation/dataset.h"
#include "io/expect_message.h"
#include "io/image.h"
#include "io/temporary_folder.h"

namespace stereo_sgmp {
namespace {

// A scene of a width, whose ground truth holds the value 24, and 0 in the first column.
void Write(const std::string& folder, int width, const std::string& left, const std::string& right,
           const std::string& truth) {
  std::filesystem::create_directories(folder);
  SaveImage(folder + "/" + left, cv::Mat(2, width, CV_8UC3, cv::Scalar(1, 2, 3)));
  SaveImage(folder + "/" + right, cv::Mat(2, width, CV_8UC3, cv::Scalar(4, 5, 6)));
  cv::Mat values(2, width, CV_8U, cv::Scalar(24));
  values.col(0).setTo(0);
  SaveImage(folder + "/" + truth, values);
}

float DisparityAt2003(int width) {
  const TemporaryFolder folder;
  Write(folder.Path("cones"), width, "im2.png", "im6.png", "disp2.png");
  return LoadScene(folder.Path("cones")).disparity.at<float>(1, 1);
}

float DisparityAt2006(int width) {
  const TemporaryFolder folder;
  Write(folder.Path("Aloe"), width, "view1.png", "view5.png", "disp1.png");
  return LoadScene(folder.Path("Aloe")).disparity.at<float>(1, 1);
}

TEST(Middlebury2003, InfersTheScaleFromTheWidth) {
  EXPECT_EQ(DisparityAt2003(434), 3) << "2001";
  EXPECT_EQ(DisparityAt2003(450), 6) << "2003, quarter size";
  EXPECT_EQ(DisparityAt2003(900), 12) << "half size";
  EXPECT_EQ(DisparityAt2003(1800), 24) << "full size";
}

TEST(Middlebury2006, InfersTheScaleFromTheWidth) {
  EXPECT_EQ(DisparityAt2006(463), 8) << "third size";
  EXPECT_EQ(DisparityAt2006(695), 12) << "half size";
  EXPECT_EQ(DisparityAt2006(1390), 24) << "full size";
}

TEST(Middlebury2003, ReadsPortablePixmaps) {
  const TemporaryFolder folder;
  Write(folder.Path("sets/venus"), 434, "im2.ppm", "im6.ppm", "disp2.pgm");
  ASSERT_EQ(FindScenes({folder.Path("sets")}).size(), 1U);
  const StereoScene scene = LoadScene(folder.Path("sets/venus"));
  EXPECT_EQ(scene.name, "venus");
  EXPECT_EQ(scene.right.at<cv::Vec3b>(0, 0), cv::Vec3b(4, 5, 6));
  EXPECT_TRUE(std::isinf(scene.disparity.at<float>(0, 0))) << "0 is not known";
  EXPECT_TRUE(scene.mask.empty());
}

TEST(Middlebury2003, TakesAnotherScale) {
  const TemporaryFolder folder;
  Write(folder.Path("tsukuba"), 384, "im2.png", "im6.png", "disp2.png");
  EXPECT_EQ(LoadScene(folder.Path("tsukuba"), {16.0}).disparity.at<float>(1, 1), 1.5);
}

TEST(Middlebury2006, TellsWhatBothCamerasSeeFromBothGroundTruths) {
  const TemporaryFolder folder;
  Write(folder.Path("Aloe"), 463, "view1.png", "view5.png", "disp1.png");
  SaveImage(folder.Path("Aloe/disp5.png"), cv::Mat(2, 463, CV_8U, cv::Scalar(24)));
  const cv::Mat mask = LoadScene(folder.Path("Aloe")).mask;
  EXPECT_EQ(mask.at<std::uint8_t>(1, 0), 0);
  EXPECT_EQ(mask.at<std::uint8_t>(1, 7), 128) << "8 pixels further left there is no image";
  EXPECT_EQ(mask.at<std::uint8_t>(1, 8), 255);
}

TEST(SeenByBoth, ComparesTheGroundTruths) {
  const float unknown = std::numeric_limits<float>::infinity();
  const cv::Mat left = (cv::Mat_<float>(1, 6) << unknown, 1, 1, 1, 3, 3);
  const cv::Mat right = (cv::Mat_<float>(1, 6) << 1, 3, 3, unknown, unknown, unknown);
  const cv::Mat expected = (cv::Mat_<std::uint8_t>(1, 6) << 0, 255, 128, 128, 255, 255);
  EXPECT_EQ(cv::norm(SeenByBoth(left, right), expected, cv::NORM_INF), 0);
}

TEST(Middlebury2006, NamesWhatIsWrong) {
  const TemporaryFolder folder;
  Write(folder.Path("Aloe"), 463, "view1.png", "view5.png", "disp1.png");
  SaveImage(folder.Path("Aloe/disp5.png"), cv::Mat(2, 400, CV_8U, cv::Scalar(24)));
  ExpectInvalid([&] { LoadScene(folder.Path("Aloe")); }, "disp5.png: 400 x 2");
  SaveImage(folder.Path("Aloe/disp1.png"), cv::Mat(2, 463, CV_8UC3, cv::Scalar(24)));
  ExpectInvalid([&] { LoadScene(folder.Path("Aloe")); }, "3 channels");
  std::filesystem::remove(folder.Path("Aloe/view5.png"));
  ExpectInvalid([&] { LoadScene(folder.Path("Aloe")); }, "view5.png");
}

}  // namespace
}  // namespace stereo_sgmp
