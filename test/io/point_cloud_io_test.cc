#include "io/pcl/point_cloud_io.h"

#include <cstring>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "io/file_io.h"
#include "io/temporary_folder.h"

namespace stereo_sgmp {
namespace {

TEST(SavePly, WritesTheValidPointsWithColourAndConfidence) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  PointCloud cloud;
  cloud.width = 3;
  cloud.height = 1;
  cloud.points = {{1, 2, 3, 10, 20, 30, 0, 0.5F},
                  {nan, nan, nan, 0, 0, 0, 0, 0.25F},
                  {4, 5, 6, 40, 50, 60, 0, 0.75F}};
  const TemporaryFolder folder;
  SavePly(folder.Path("a.ply"), cloud);
  const std::string bytes = ReadFile(folder.Path("a.ply"));
  const std::string end = "end_header\n";
  const std::string header = bytes.substr(0, bytes.find(end));
  EXPECT_NE(header.find("format binary_little_endian"), std::string::npos) << header;
  EXPECT_NE(header.find("element vertex 2\n"), std::string::npos) << header;
  EXPECT_NE(header.find("property float x\nproperty float y\nproperty float z\n"
                        "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                        "property float confidence\n"),
            std::string::npos)
      << header;
  constexpr std::size_t kPointBytes = 4 * sizeof(float) + 3;
  const std::string body = bytes.substr(bytes.find(end) + end.size());
  ASSERT_EQ(body.size(), 2 * kPointBytes);
  const std::string second = body.substr(kPointBytes);
  float xyz[3];
  std::memcpy(xyz, second.data(), sizeof(xyz));
  EXPECT_EQ(xyz[0], 4);
  EXPECT_EQ(xyz[2], 6);
  EXPECT_EQ(second.substr(12, 3), std::string("\x3c\x32\x28")) << "red, green, blue";
  float confidence = 0;
  std::memcpy(&confidence, second.data() + 15, sizeof(confidence));
  EXPECT_EQ(confidence, 0.75F);
}

TEST(SavePly, WritesAnEmptyCloud) {
  const TemporaryFolder folder;
  SavePly(folder.Path("a.ply"), PointCloud());
  EXPECT_NE(ReadFile(folder.Path("a.ply")).find("element vertex 0"), std::string::npos);
}

}  // namespace
}  // namespace stereo_sgmp
