#include "io/disparity_file.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/expect_message.h"
#include "io/file_io.h"
#include "io/image.h"
#include "io/pfm.h"
#include "io/temporary_folder.h"

namespace stereo_sgmp {
namespace {

using testing::ElementsAre;
using testing::FloatEq;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::vector<float> Values(const cv::Mat& map) {
  EXPECT_EQ(map.type(), CV_32FC1);
  return {map.begin<float>(), map.end<float>()};
}

class DisparityFile : public testing::Test {
 protected:
  std::string Pfm(const std::string& name, const std::vector<float>& values) const {
    WritePfm(folder_.Path(name), cv::Mat(values, true).reshape(1, 1));
    return folder_.Path(name);
  }
  template <class T>
  std::string Png(const std::string& name, const std::vector<T>& values) const {
    SaveImage(folder_.Path(name), cv::Mat(values, true).reshape(1, 1));
    return folder_.Path(name);
  }

  TemporaryFolder folder_;
};

StereoCamera Camera() {
  StereoCamera camera;
  camera.focal_length = 500.0;
  camera.baseline = 0.2;
  camera.doffs = 10.0;
  return camera;
}

TEST_F(DisparityFile, OfFloatsIsTakenAsItIs) {
  EXPECT_THAT(Values(ReadDisparity(Pfm("d.pfm", {1.5f, 0.0f, -3.0f}), 0)),
              ElementsAre(1.5f, 0.0f, -3.0f));
  EXPECT_THAT(Values(ReadDisparity(Pfm("D.PFM", {kInfinity, -kInfinity, kNan}), 0)),
              ElementsAre(kInfinity, kInfinity, kInfinity));
}

TEST_F(DisparityFile, Of16BitIsInUnitsOf256thPixels) {
  EXPECT_THAT(Values(ReadDisparity(Png<std::uint16_t>("d.png", {0, 1, 256, 65535}), 0)),
              ElementsAre(kInfinity, 1.0f / 256, 1.0f, 65535.0f / 256));
}

TEST_F(DisparityFile, Of8BitIsInPixels) {
  EXPECT_THAT(Values(ReadDisparity(Png<std::uint8_t>("d.png", {0, 1, 255}), 0)),
              ElementsAre(kInfinity, 1.0f, 255.0f));
}

TEST_F(DisparityFile, IsDividedByTheScaleGiven) {
  EXPECT_THAT(Values(ReadDisparity(Pfm("d.pfm", {3.0f, kNan}), 2)), ElementsAre(1.5f, kInfinity));
  EXPECT_THAT(Values(ReadDisparity(Png<std::uint16_t>("16.png", {0, 300}), 100)),
              ElementsAre(kInfinity, 3.0f));
  EXPECT_THAT(Values(ReadDisparity(Png<std::uint8_t>("8.png", {0, 9}), 4)),
              ElementsAre(kInfinity, 2.25f));
}

TEST_F(DisparityFile, KeepsTheLayoutOfTheMap) {
  cv::Mat image(2, 3, CV_8U);
  for (int i = 0; i < 6; ++i) image.data[i] = static_cast<std::uint8_t>(i + 1);
  SaveImage(folder_.Path("d.png"), image);
  const cv::Mat map = ReadDisparity(folder_.Path("d.png"), 0);
  EXPECT_EQ(map.size(), cv::Size(3, 2));
  EXPECT_EQ(map.at<float>(1, 0), 4.0f);
}

TEST_F(DisparityFile, RefusesScalesThatAreNone) {
  const std::string path = Pfm("d.pfm", {1.0f});
  for (const double scale : {-1.0, static_cast<double>(kNan), static_cast<double>(kInfinity)}) {
    ExpectInvalid([&] { ReadDisparity(path, scale); }, "a number above 0 is expected");
  }
  ExpectInvalid([&] { ReadDisparity(path, -2.5); }, "d.pfm: the scale of its disparities is -2.5");
}

TEST_F(DisparityFile, RefusesFilesThatAreNone) {
  const std::string pfm = ReadFile(Pfm("d.pfm", {1.0f, 2.0f}));
  const std::string png = ReadFile(Png<std::uint8_t>("d.png", {1, 2}));
  const struct {
    std::string path;
    std::string message;
  } cases[] = {
      {folder_.Path("none.pfm"), "no such file"},
      {folder_.Path(""), "folder"},
      {folder_.Write("empty.pfm", ""), "empty"},
      {folder_.Write("short.pfm", pfm.substr(0, pfm.size() - 1)), "truncated"},
      {folder_.Write("short.png", png.substr(0, png.size() - 20)), "truncated"},
      {folder_.Write("text.png", "words"), "not a picture"},
      {folder_.Write("png.pfm", png), "a PFM file starts with"},
  };
  for (const auto& c : cases) {
    ExpectInvalid([&] { ReadDisparity(c.path, 0); }, c.message);
    ExpectInvalid([&] { ReadDepthAsDisparity(c.path, Camera()); }, c.message);
  }
}

TEST_F(DisparityFile, RefusesSeveralChannels) {
  WritePfm(folder_.Path("n.pfm"), cv::Mat(2, 2, CV_32FC3, cv::Scalar(1, 2, 3)));
  SaveImage(folder_.Path("n.png"), cv::Mat(2, 2, CV_8UC3, cv::Scalar(1, 2, 3)));
  ExpectInvalid([&] { ReadDisparity(folder_.Path("n.pfm"), 0); }, "3 channels found, one is");
  ExpectInvalid([&] { ReadDisparity(folder_.Path("n.png"), 0); }, "3 channels found, one is");
}

TEST_F(DisparityFile, OfDepthsHoldsMetresOrMillimetres) {
  // d = 500 * 0.2 / z - 10
  EXPECT_THAT(Values(ReadDepthAsDisparity(Pfm("z.pfm", {2.0f, 20.0f}), Camera())),
              ElementsAre(FloatEq(40.0f), FloatEq(-5.0f)));
  EXPECT_THAT(Values(ReadDepthAsDisparity(Png<std::uint16_t>("z.png", {0, 2000, 2500}), Camera())),
              ElementsAre(kInfinity, FloatEq(40.0f), FloatEq(30.0f)));
}

TEST_F(DisparityFile, OfDepthsKnowsNothingWhereTheyAreImpossible) {
  const std::string path = Pfm("z.pfm", {0.0f, -1.0f, kNan, kInfinity, 1e-45f});
  EXPECT_THAT(Values(ReadDepthAsDisparity(path, Camera())),
              ElementsAre(kInfinity, kInfinity, kInfinity, kInfinity, kInfinity));
}

TEST_F(DisparityFile, OfDepthsNeedsACameraAndMoreThan8Bit) {
  const std::string path = Pfm("z.pfm", {1.0f});
  ExpectInvalid([&] { ReadDepthAsDisparity(path, StereoCamera()); }, "focal_length");
  const std::string coarse = Png<std::uint8_t>("z.png", {1});
  ExpectInvalid([&] { ReadDepthAsDisparity(coarse, Camera()); }, "16-bit picture of millimetres");
}

}  // namespace
}  // namespace stereo_sgmp
