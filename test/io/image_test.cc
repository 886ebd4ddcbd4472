#include "io/image.h"

#include <cstdint>
#include <string>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "io/expect_message.h"
#include "io/file_io.h"
#include "io/temporary_folder.h"

namespace stereo_sgmp {
namespace {

cv::Mat RandomImage(int type) {
  cv::Mat image(40, 50, type);
  cv::theRNG().fill(image, cv::RNG::UNIFORM, 0, 255);
  return image;
}

TEST(Image, IsLoadedAsItIsStored) {
  const TemporaryFolder folder;
  for (const int type : {CV_8UC1, CV_8UC3, CV_8UC4, CV_16UC1, CV_16UC3}) {
    const cv::Mat image = RandomImage(type);
    SaveImage(folder.Path("a.png"), image);
    const cv::Mat copy = LoadImage(folder.Path("a.png"));
    ASSERT_EQ(copy.type(), type);
    EXPECT_EQ(cv::norm(copy, image, cv::NORM_INF), 0);
  }
  EXPECT_EQ(folder.Count(), 1) << "a temporary file was left behind";
}

TEST(Image, NamesFilesThatAreNone) {
  const TemporaryFolder folder;
  ExpectInvalid([&] { LoadImage(folder.Path("none.png")); }, "no such file");
  ExpectInvalid([&] { LoadImage(folder.Path("")); }, "folder");
  ExpectInvalid([&] { LoadImage(folder.Write("empty.png", "")); }, "empty");
  ExpectInvalid([&] { LoadImage(folder.Write("text.png", "not a picture")); }, "not a picture");
}

TEST(Image, RecognisesTruncatedFiles) {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "a.jpg"}) {
    SaveImage(folder.Path(name), RandomImage(CV_8UC3));
    const std::string bytes = ReadFile(folder.Path(name));
    for (const std::size_t length : {std::size_t{4}, bytes.size() / 2, bytes.size() - 20}) {
      folder.Write(name, bytes.substr(0, length));
      ExpectInvalid([&] { LoadImage(folder.Path(name)); }, "truncated");
    }
  }
}

TEST(Image, MakesNoRoomForPixelsThatAFileDoesNotHold) {
  const TemporaryFolder folder;
  for (const char* header :
       {"P6\n666\n666332 255\n", "P5 # 1 2\n40000 40000 255\n", "P4\n99999 9999\n"}) {
    const std::string path = folder.Write("a.ppm", std::string(header) + "pixels");
    ExpectInvalid([&] { LoadImage(path); }, "truncated");
  }
}

TEST(Image, RefusesFloatPictures) {
  const TemporaryFolder folder;
  cv::imwrite(folder.Path("a.tiff"), cv::Mat::ones(4, 4, CV_32F));
  ExpectInvalid([&] { LoadImage(folder.Path("a.tiff")); }, "8 or 16 bit");
}

TEST(Image, LeavesOtherFormatsUntouched) {
  const TemporaryFolder folder;
  // The first would take 10 GB, the second ends the process in some decoders.
  for (const std::string& bytes :
       {std::string("PF\n30000 30000\n-1.0\n"), std::string(128, '\x9F') + "DICM\xC0\x7F"}) {
    const std::string path = folder.Write("a.png", bytes);
    ExpectInvalid([&] { LoadImage(path); }, "not a picture that can be read");
  }
}

TEST(Image, ReadsTheFormatsItNames) {
  const TemporaryFolder folder;
  const cv::Mat image = RandomImage(CV_8UC3);
  for (const char* name : {"a.png", "a.jpg", "a.ppm", "a.tiff", "a.bmp", "a.webp"}) {
    ASSERT_TRUE(cv::imwrite(folder.Path(name), image));
    EXPECT_EQ(LoadImage(folder.Path(name)).size(), image.size()) << name;
  }
}

TEST(Image, PairsMustAgree) {
  const cv::Mat image = RandomImage(CV_8UC3);
  CheckPair(image, "l.png", image, "r.png");
  ExpectInvalid([&] { CheckPair(image, "l.png", image.rowRange(0, 39), "r.png"); }, "50 x 39");
  ExpectInvalid([&] { CheckPair(image, "l.png", RandomImage(CV_16UC3), "r.png"); }, "16 bit");
  ExpectInvalid([&] { CheckPair(image, "l.png", RandomImage(CV_8UC1), "r.png"); }, "r.png");
}

TEST(Image, LosesTheLowerBitsIn8Bit) {
  const cv::Mat deep = (cv::Mat_<std::uint16_t>(1, 3) << 0, 257 * 100, 65535);
  const cv::Mat expected = (cv::Mat_<std::uint8_t>(1, 3) << 0, 100, 255);
  EXPECT_EQ(cv::norm(To8Bit(deep), expected, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(To8Bit(expected), expected, cv::NORM_INF), 0);
}

TEST(Image, IsNotSavedUnderANameWithoutFormat) {
  const TemporaryFolder folder;
  ExpectInvalid([&] { SaveImage(folder.Path("a.xyz"), RandomImage(CV_8UC3)); }, ".xyz");
  EXPECT_THROW(SaveImage(folder.Path("none/a.png"), RandomImage(CV_8UC3)), std::runtime_error);
  EXPECT_EQ(folder.Count(), 0);
}

}  // namespace
}  // namespace stereo_sgmp
