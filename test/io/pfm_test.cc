#include "io/pfm.h"

#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/expect_message.h"
#include "io/temporary_folder.h"

namespace stereo_sgmp {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::string FloatBytes(const std::vector<float>& values, bool little_endian) {
  std::string bytes;
  for (const float value : values) {
    std::uint32_t word = 0;
    std::memcpy(&word, &value, sizeof(word));
    for (int i = 0; i < 4; ++i) {
      const int shift = 8 * (little_endian ? i : 3 - i);
      bytes += static_cast<char>(word >> shift & 0xFF);
    }
  }
  return bytes;
}

void ExpectSame(const cv::Mat& a, const cv::Mat& b) {
  ASSERT_EQ(a.type(), b.type());
  ASSERT_EQ(a.size(), b.size());
  for (int y = 0; y < a.rows; ++y) {
    EXPECT_EQ(std::memcmp(a.ptr(y), b.ptr(y), a.elemSize() * static_cast<std::size_t>(a.cols)), 0)
        << "row " << y;
  }
}

TEST(Pfm, ReadsBackWhatItWrote) {
  const TemporaryFolder folder;
  for (const int type : {CV_32FC1, CV_32FC3}) {
    for (const cv::Size size : {cv::Size(1, 1), cv::Size(7, 3), cv::Size(2, 64)}) {
      cv::Mat image(size, type);
      cv::theRNG().fill(image, cv::RNG::UNIFORM, -100, 100);
      image.ptr<float>(0)[0] = kInfinity;
      WritePfm(folder.Path("a.pfm"), image);
      ExpectSame(ReadPfm(folder.Path("a.pfm")), image);
    }
  }
}

TEST(Pfm, WritesRowsOfAView) {
  const TemporaryFolder folder;
  cv::Mat image(5, 9, CV_32F);
  cv::theRNG().fill(image, cv::RNG::UNIFORM, 0, 1);
  const cv::Mat view = image(cv::Rect(2, 1, 4, 3));
  WritePfm(folder.Path("a.pfm"), view);
  ExpectSame(ReadPfm(folder.Path("a.pfm")), view);
}

TEST(Pfm, FirstRowInTheFileIsTheBottom) {
  const cv::Mat image = DecodePfm("Pf\n2 2\n-1.0\n" + FloatBytes({1, 2, 3, 4}, true), "x.pfm");
  EXPECT_EQ(image.at<float>(1, 0), 1);
  EXPECT_EQ(image.at<float>(1, 1), 2);
  EXPECT_EQ(image.at<float>(0, 0), 3);
}

TEST(Pfm, ReadsBothByteOrders) {
  const std::vector<float> values = {1.5F, -2.25F, kInfinity};
  const cv::Mat little = DecodePfm("Pf 3 1 -0.5\n" + FloatBytes(values, true), "x.pfm");
  const cv::Mat big = DecodePfm("Pf\n3 1\n255\n" + FloatBytes(values, false), "x.pfm");
  ExpectSame(little, big);
  EXPECT_EQ(big.at<float>(0, 1), -2.25F);
}

TEST(Pfm, ReadsThreeChannelsInTheirOrder) {
  const cv::Mat image = DecodePfm("PF\n1 1\n-1\n" + FloatBytes({1, 2, 3}, true), "x.pfm");
  EXPECT_EQ(image.at<cv::Vec3f>(0, 0), cv::Vec3f(1, 2, 3));
}

TEST(Pfm, NamesWhatIsWrongWithAFile) {
  const TemporaryFolder folder;
  ExpectInvalid([&] { ReadPfm(folder.Path("none.pfm")); }, "no such file");
  ExpectInvalid([&] { ReadPfm(folder.Path("")); }, "folder");
  ExpectInvalid([&] { ReadPfm(folder.Write("empty.pfm", "")); }, "empty");
  ExpectInvalid([&] { ReadPfm(folder.Write("short.pfm", "Pf\n2 2\n-1\n1234")); }, "short.pfm");
}

TEST(Pfm, NamesWhatIsWrongWithTheContent) {
  const struct {
    std::string bytes;
    std::string message;
  } cases[] = {
      {"P5\n2 2\n255\n1234", "\"P5\""},
      {"\x89PNG\r\n\x1a\n", "\"?PNG\""},
      {"Pf", "width"},
      {"Pf\n0 2\n-1\n", "width"},
      {"Pf\n-3 2\n-1\n", "width"},
      {"Pf\n2.5 2\n-1\n", "width"},
      {"Pf\n99999999999999999999 2\n-1\n", "width"},
      {"Pf\n2 70000\n-1\n", "height"},
      {"Pf\n2 x\n-1\n", "height"},
      {"Pf\n2 2\nnan\n", "scale"},
      {"Pf\n2 2\n0\n", "scale"},
      {"Pf\n2 2\ninf\n", "scale"},
      {"Pf\n2 2\n", "scale"},
      {"Pf\n2 2\n-1", "truncated"},
      {"Pf\n2 2\n-1\n" + std::string(15, 'x'), "truncated"},
      {"Pf\n65536 65536\n-1\n1234", "truncated"},
  };
  for (const auto& c : cases) {
    ExpectInvalid([&] { DecodePfm(c.bytes, "x.pfm"); }, c.message);
  }
}

TEST(Pfm, RefusesToWriteOtherTypes) {
  const TemporaryFolder folder;
  ExpectInvalid([&] { WritePfm(folder.Path("a.pfm"), cv::Mat(2, 2, CV_8U)); }, "float");
  ExpectInvalid([&] { WritePfm(folder.Path("a.pfm"), cv::Mat()); }, "float");
  EXPECT_EQ(folder.Count(), 0);
}

TEST(Pfm, LeavesNothingBehindWhenItCannotWrite) {
  const TemporaryFolder folder;
  EXPECT_THROW(WritePfm(folder.Path("none/a.pfm"), cv::Mat::zeros(2, 2, CV_32F)),
               std::runtime_error);
  EXPECT_EQ(folder.Count(), 0);
}

}  // namespace
}  // namespace stereo_sgmp
