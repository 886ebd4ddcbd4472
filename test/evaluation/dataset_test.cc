#include "evaluation/dataset.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "io/expect_message.h"
#include "io/image.h"
#include "io/pfm.h"
#include "io/temporary_folder.h"

namespace stereo_sgmp {
namespace {

StereoScene SmallScene() {
  StereoScene scene;
  scene.left = cv::Mat(6, 8, CV_8UC3, cv::Scalar(10, 20, 30));
  scene.right = cv::Mat(6, 8, CV_8UC3, cv::Scalar(40, 50, 60));
  scene.disparity = cv::Mat(6, 8, CV_32F, cv::Scalar(2.5));
  scene.mask = cv::Mat(6, 8, CV_8U, cv::Scalar(128));
  scene.normals = cv::Mat(6, 8, CV_32FC3, cv::Scalar(0, 0.6, -0.8));
  Calibration calibration;
  calibration.camera.focal_length = 100;
  calibration.camera.baseline = 0.1;
  calibration.num_disparities = 4;
  scene.calibration = calibration;
  return scene;
}

TEST(Dataset, ReadsBackWhatItWrote) {
  const TemporaryFolder folder;
  const StereoScene scene = SmallScene();
  SaveScene(folder.Path("sets/a"), scene);
  const StereoScene copy = LoadScene(folder.Path("sets/a/"));
  EXPECT_EQ(copy.name, "a");
  EXPECT_EQ(cv::norm(copy.left, scene.left, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(copy.right, scene.right, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(copy.disparity, scene.disparity, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(copy.mask, scene.mask, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(copy.normals, scene.normals, cv::NORM_INF), 0);
  ASSERT_TRUE(copy.calibration.has_value());
  EXPECT_EQ(copy.calibration->num_disparities, 4);
}

TEST(Dataset, DoesWithoutMaskNormalsAndCalibration) {
  const TemporaryFolder folder;
  StereoScene scene = SmallScene();
  scene.mask.release();
  scene.normals.release();
  scene.calibration.reset();
  SaveScene(folder.Path("a"), scene);
  const StereoScene copy = LoadScene(folder.Path("a"));
  EXPECT_TRUE(copy.mask.empty());
  EXPECT_TRUE(copy.normals.empty());
  EXPECT_FALSE(copy.calibration.has_value());
}

TEST(Dataset, FindsScenesInTheOrderOfTheirNames) {
  const TemporaryFolder folder;
  for (const char* name : {"sets/b", "sets/a", "single"})
    SaveScene(folder.Path(name), SmallScene());
  std::filesystem::create_directory(folder.Path("sets/other"));
  const std::vector<std::string> expected = {folder.Path("single"), folder.Path("sets/a"),
                                             folder.Path("sets/b")};
  EXPECT_EQ(FindScenes({folder.Path("single"), folder.Path("sets")}), expected);
}

TEST(Dataset, NamesWhatIsWrongWithAFolder) {
  const TemporaryFolder folder;
  ExpectInvalid([&] { FindScenes({folder.Path("none")}); }, "no such folder");
  ExpectInvalid([&] { FindScenes({folder.Path("")}); }, "neither a scene");
  SaveScene(folder.Path("a"), SmallScene());
  WritePfm(folder.Path("a/disp0GT.pfm"), cv::Mat::ones(5, 8, CV_32F));
  ExpectInvalid([&] { LoadScene(folder.Path("a")); }, "8 x 5");
  WritePfm(folder.Path("a/disp0GT.pfm"), cv::Mat::ones(6, 8, CV_32FC3));
  ExpectInvalid([&] { LoadScene(folder.Path("a")); }, "3 channels");
  std::filesystem::remove(folder.Path("a/im1.png"));
  ExpectInvalid([&] { LoadScene(folder.Path("a")); }, "im1.png");
}

TEST(Dataset, TakesTheGroundTruthOfDownloadsToo) {
  const TemporaryFolder folder;
  SaveScene(folder.Path("a"), SmallScene());
  std::filesystem::rename(folder.Path("a/disp0GT.pfm"), folder.Path("a/disp0.pfm"));
  EXPECT_EQ(LoadScene(folder.Path("a")).disparity.at<float>(2, 2), 2.5F);
}

TEST(Dataset, RefusesNormalsThatAreNone) {
  const TemporaryFolder folder;
  SaveScene(folder.Path("a"), SmallScene());
  WritePfm(folder.Path("a/normals0.pfm"), cv::Mat(6, 8, CV_32FC3, cv::Scalar::all(1)));
  ExpectInvalid([&] { LoadScene(folder.Path("a")); }, "length");
  WritePfm(folder.Path("a/normals0.pfm"), cv::Mat::zeros(6, 7, CV_32FC3));
  ExpectInvalid([&] { LoadScene(folder.Path("a")); }, "7 x 6");
}

TEST(Dataset, RefusesMasksOfAnotherKind) {
  const TemporaryFolder folder;
  SaveScene(folder.Path("a"), SmallScene());
  SaveImage(folder.Path("a/mask0nocc.png"), cv::Mat::zeros(6, 8, CV_8UC3));
  ExpectInvalid([&] { LoadScene(folder.Path("a")); }, "8 bit gray");
  SaveImage(folder.Path("a/mask0nocc.png"), cv::Mat::zeros(6, 7, CV_8U));
  ExpectInvalid([&] { LoadScene(folder.Path("a")); }, "7 x 6");
}

}  // namespace
}  // namespace stereo_sgmp
