#include "evaluation/datasets/kitti.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "evaluation/dataset.h"
#include "io/expect_message.h"
#include "io/image.h"
#include "io/temporary_folder.h"

namespace stereo_sgmp {
namespace {

void WriteImage(const std::string& folder, const std::string& frame, const cv::Mat& image) {
  std::filesystem::create_directories(folder);
  SaveImage(folder + "/" + frame, image);
}

// A frame whose disparities are 2.5 but for one that is not known.
void WriteFrame(const std::string& training, const std::string& left, const std::string& right,
                const std::string& truth, const std::string& frame) {
  WriteImage(training + "/" + left, frame, cv::Mat(4, 9, CV_8UC3, cv::Scalar(1, 2, 3)));
  WriteImage(training + "/" + right, frame, cv::Mat(4, 9, CV_8UC3, cv::Scalar(4, 5, 6)));
  cv::Mat values(4, 9, CV_16U, cv::Scalar(640));
  values.at<std::uint16_t>(0, 0) = 0;
  WriteImage(training + "/" + truth, frame, values);
}

TEST(Kitti, ReadsEachFrameOf2015) {
  const TemporaryFolder folder;
  const std::string training = folder.Path("kitti/training");
  for (const char* frame : {"000001_10.png", "000000_10.png"}) {
    WriteFrame(training, "image_2", "image_3", "disp_noc_0", frame);
  }
  WriteImage(training + "/image_2", "000000_11.png", cv::Mat::zeros(4, 9, CV_8UC3));
  WriteImage(folder.Path("kitti/testing/image_2"), "000000_10.png", cv::Mat::zeros(4, 9, CV_8UC3));
  const std::vector<std::string> expected = {training + "/image_2/000000_10.png",
                                             training + "/image_2/000001_10.png"};
  EXPECT_EQ(FindScenes({training}), expected);
  EXPECT_EQ(FindScenes({folder.Path("kitti")}), expected);
  EXPECT_EQ(FindScenes({expected[1]}), std::vector<std::string>{expected[1]});
  const StereoScene scene = LoadScene(expected[1]);
  EXPECT_EQ(scene.name, "000001_10");
  EXPECT_EQ(scene.left.at<cv::Vec3b>(0, 0), cv::Vec3b(1, 2, 3));
  EXPECT_EQ(scene.right.at<cv::Vec3b>(0, 0), cv::Vec3b(4, 5, 6));
  EXPECT_EQ(scene.disparity.at<float>(1, 1), 2.5);
  EXPECT_TRUE(std::isinf(scene.disparity.at<float>(0, 0)));
  EXPECT_FALSE(scene.calibration.has_value());
}

TEST(Kitti, ReadsFramesOf2012) {
  const TemporaryFolder folder;
  WriteFrame(folder.Path("training"), "image_0", "image_1", "disp_noc", "000007_10.png");
  const std::vector<std::string> scenes = FindScenes({folder.Path("training")});
  ASSERT_EQ(scenes.size(), 1U);
  EXPECT_EQ(LoadScene(scenes[0]).right.at<cv::Vec3b>(0, 0), cv::Vec3b(4, 5, 6));
}

TEST(Kitti, NamesWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string frame = "000007_10.png";
  WriteFrame(folder.Path("training"), "image_2", "image_3", "disp_noc_0", frame);
  const std::string scene = FindScenes({folder.Path("training")})[0];
  WriteImage(folder.Path("training/disp_noc_0"), frame, cv::Mat::zeros(4, 8, CV_16U));
  ExpectInvalid([&] { LoadScene(scene); }, "8 x 4");
  std::filesystem::remove(folder.Path("training/image_3/" + frame));
  ExpectInvalid([&] { LoadScene(scene); }, "image_3");
  ExpectInvalid([&] { LoadScene(folder.Path("training")); }, "neither a scene");
  std::filesystem::remove(folder.Path("training/disp_noc_0/" + frame));
  ExpectInvalid([&] { FindScenes({folder.Path("training")}); }, "neither a scene");
}

}  // namespace
}  // namespace stereo_sgmp
