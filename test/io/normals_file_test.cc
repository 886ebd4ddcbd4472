#include "io/normals_file.h"

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "io/expect_message.h"
#include "io/file_io.h"
#include "io/pfm.h"
#include "io/temporary_folder.h"

namespace stereo_sgmp {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(NormalsFile, IsReadWithZeroWhereNothingIsKnown) {
  const TemporaryFolder folder;
  cv::Mat normals(1, 4, CV_32FC3, cv::Scalar::all(0));
  normals.at<cv::Vec3f>(0, 1) = {0.6f, 0.0f, -0.8f};
  normals.at<cv::Vec3f>(0, 2) = {0.0f, kNan, -1.0f};
  normals.at<cv::Vec3f>(0, 3) = {0.0f, std::numeric_limits<float>::infinity(), 0.0f};
  WritePfm(folder.Path("n.pfm"), normals);
  const cv::Mat read = ReadNormals(folder.Path("n.pfm"));
  ASSERT_EQ(read.type(), CV_32FC3);
  EXPECT_EQ(read.at<cv::Vec3f>(0, 1), cv::Vec3f(0.6f, 0.0f, -0.8f));
  for (const int x : {0, 2, 3}) EXPECT_EQ(read.at<cv::Vec3f>(0, x), cv::Vec3f::all(0)) << x;
}

TEST(NormalsFile, RefusesVectorsOfAnotherLength) {
  const TemporaryFolder folder;
  cv::Mat normals(2, 3, CV_32FC3, cv::Scalar(0, 0, -1));
  normals.at<cv::Vec3f>(1, 2) = {0.5f, 0.5f, 0.0f};
  WritePfm(folder.Path("n.pfm"), normals);
  ExpectInvalid([&] { ReadNormals(folder.Path("n.pfm")); }, "x 2, y 1 has length 0.707");
}

TEST(NormalsFile, RefusesFilesThatAreNone) {
  const TemporaryFolder folder;
  WritePfm(folder.Path("d.pfm"), cv::Mat(2, 2, CV_32F, cv::Scalar(1)));
  WritePfm(folder.Path("n.pfm"), cv::Mat(2, 2, CV_32FC3, cv::Scalar(0, 0, -1)));
  const std::string whole = ReadFile(folder.Path("n.pfm"));
  ExpectInvalid([&] { ReadNormals(folder.Path("d.pfm")); }, "one channel found, three");
  ExpectInvalid([&] { ReadNormals(folder.Path("none.pfm")); }, "no such file");
  ExpectInvalid([&] { ReadNormals(folder.Path("")); }, "folder");
  ExpectInvalid([&] { ReadNormals(folder.Write("e.pfm", "")); }, "empty");
  ExpectInvalid([&] { ReadNormals(folder.Write("s.pfm", whole.substr(0, 40))); }, "truncated");
}

}  // namespace
}  // namespace stereo_sgmp
