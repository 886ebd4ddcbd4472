#include "io/cost_volume_file.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/expect_message.h"
#include "io/file_io.h"
#include "io/temporary_folder.h"

namespace stereo_sgmp {
namespace {

using testing::ElementsAre;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::string Bytes(const std::vector<float>& values) {
  std::string bytes(values.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

std::string BigEndian(std::string bytes) {
  for (auto i = bytes.begin(); i != bytes.end(); i += 4) std::reverse(i, i + 4);
  return bytes;
}

CostVolume Shape(int width, int height, int disparities) {
  CostVolume volume;
  volume.width = width;
  volume.height = height;
  volume.disparities = disparities;
  return volume;
}

CostVolume RandomVolume() {
  CostVolume volume = Shape(5, 3, 7);
  volume.min_disparity = -4;
  volume.costs.resize(105);
  std::uint32_t state = 1;
  for (std::uint8_t& cost : volume.costs) {
    state = state * 1664525 + 1013904223;
    cost = static_cast<std::uint8_t>(state >> 24);
  }
  return volume;
}

class CostVolumeFile : public testing::Test {
 protected:
  std::vector<std::uint8_t> Costs(const std::string& name, const std::vector<float>& values) const {
    CostVolume volume = Shape(static_cast<int>(values.size()), 1, 1);
    ReadCosts(folder_.Write(name, Bytes(values)), &volume);
    return volume.costs;
  }

  TemporaryFolder folder_;
};

TEST_F(CostVolumeFile, ReadsBackWhatItWrote) {
  const CostVolume volume = RandomVolume();
  for (const char* name : {"v.bin", "v.acrt"}) {
    const std::string path = folder_.Path(name);
    WriteCostVolume(path, volume);
    std::optional<CostVolume> copy = ReadCostVolumeShape(path);
    ASSERT_TRUE(copy);
    EXPECT_EQ(copy->width, 5);
    EXPECT_EQ(copy->height, 3);
    EXPECT_EQ(copy->disparities, 7);
    EXPECT_EQ(copy->min_disparity, -4);
    ReadCosts(path, &*copy);
    EXPECT_EQ(copy->costs, volume.costs);
  }
}

TEST_F(CostVolumeFile, HoldsEveryCostExactly) {
  CostVolume volume = Shape(256, 1, 1);
  volume.costs.resize(256);
  std::iota(volume.costs.begin(), volume.costs.end(), std::uint8_t{0});
  for (const char* name : {"v.bin", "v.acrt"}) {
    CostVolume copy = Shape(256, 1, 1);
    WriteCostVolume(folder_.Path(name), volume);
    ReadCosts(folder_.Path(name), &copy);
    EXPECT_EQ(copy.costs, volume.costs) << name;
  }
  std::vector<float> cosine(256);
  for (std::size_t c = 0; c < 256; ++c) cosine[c] = static_cast<float>(c) / 255.0f - 1.0f;
  EXPECT_EQ(Costs("fast.bin", cosine), volume.costs);
}

TEST_F(CostVolumeFile, LiesDisparityByDisparity) {
  CostVolume volume = Shape(2, 3, 2);  // value of index k at (x, y): (6 k + 2 y + x) / 255
  std::vector<float> values(12);
  for (std::size_t i = 0; i < 12; ++i) values[i] = static_cast<float>(i) / 255.0f;
  ReadCosts(folder_.Write("v.acrt", Bytes(values)), &volume);
  EXPECT_EQ(volume.At(2, 1)[0], 5);
  EXPECT_EQ(volume.At(1, 0)[1], 8);
}

TEST_F(CostVolumeFile, OfTheAccurateNetIsASigmoid) {
  for (const char* name : {"v.acrt", "v.bin"}) {
    EXPECT_THAT(Costs(name, {0.0f, 1.0f, 0.5f, 0.1f, kNan, -0.0f, 1.0005f}),
                ElementsAre(0, 255, 128, 26, 255, 0, 255))
        << name;
  }
}

TEST_F(CostVolumeFile, OfTheFastNetIsANegatedCosine) {
  EXPECT_THAT(Costs("v.bin", {-1.0f, 0.0f, 1.0f, -0.5f, -0.1f, kNan, -1.0005f}),
              ElementsAre(0, 255, 255, 128, 230, 255, 0));
}

// The first disparities of a fast net's volume need not hold a negative value.
TEST_F(CostVolumeFile, OfTheFastNetIsRecognisedByItsLastValue) {
  CostVolume volume = Shape(1, 1, 3);
  ReadCosts(folder_.Write("v.bin", Bytes({0.5f, 0.25f, -1.0f})), &volume);
  EXPECT_THAT(volume.costs, ElementsAre(255, 255, 0));
}

TEST_F(CostVolumeFile, RefusesImpossibleValuesByPosition) {
  const auto expect = [&](const std::string& name, float value, const std::string& message) {
    std::vector<float> values(12, 0.7f);
    values[9] = value;
    CostVolume volume = Shape(2, 3, 2);
    const std::string path = folder_.Write(name, Bytes(values));
    ExpectInvalid([&] { ReadCosts(path, &volume); }, message);
  };
  const std::string where = "x 1, y 1, disparity index 1 is ";
  expect("v.acrt", 1.5f, where + "1.5, but 0 to 1 or NaN are expected");
  expect("v.acrt", -0.5f, where + "-0.5, but 0 to 1");
  expect("v.acrt", kInfinity, where + "inf");
  expect("v.bin", -1.5f, where + "-1.5, but -1 to 1 or NaN are expected");
  expect("v.bin", -kInfinity, where + "-inf");
  expect("v.bin", 3e20f, "-sm_terminate cnn");
}

TEST_F(CostVolumeFile, RefusesTheOtherByteOrder) {
  const CostVolume volume = RandomVolume();
  for (const char* name : {"v.bin", "v.acrt"}) {
    WriteCostVolume(folder_.Path(name), volume);
    const std::string swapped = BigEndian(ReadFile(folder_.Path(name)));
    folder_.Write(name, swapped);
    CostVolume copy = Shape(5, 3, 7);
    ExpectInvalid([&] { ReadCosts(folder_.Path(name), &copy); }, "big-endian");
  }
}

TEST_F(CostVolumeFile, RefusesFilesOfAnotherSize) {
  const std::string bytes = Bytes(std::vector<float>(12, 0.5f));
  const auto expect = [&](const std::string& content, const std::string& message) {
    CostVolume volume = Shape(2, 3, 2);
    const std::string path = folder_.Write("v.bin", content);
    ExpectInvalid([&] { ReadCosts(path, &volume); }, message);
  };
  expect("", "has 0 bytes, but 2 x 3 pixels and 2 disparities need 48; it is truncated");
  expect(bytes.substr(1), "has 47 bytes, but 2 x 3 pixels and 2 disparities need 48; it is trunc");
  expect(bytes + "x", "has 49 bytes, but 2 x 3 pixels and 2 disparities need 48; it is of another");
  expect(bytes + bytes, "has 96 bytes");
  expect(bytes + bytes, "the file may be one of 4 disparities");
  expect(bytes.substr(24), "the file may be one of 1 disparities");
}

TEST_F(CostVolumeFile, RefusesFilesThatAreNone) {
  CostVolume volume = Shape(2, 3, 2);
  ExpectInvalid([&] { ReadCosts(folder_.Path("none.bin"), &volume); }, "no such file");
  std::filesystem::create_directory(folder_.Path("folder.bin"));
  ExpectInvalid([&] { ReadCosts(folder_.Path("folder.bin"), &volume); }, "folder");
  ExpectInvalid([&] { ReadCosts(folder_.Write("v.png", "x"), &volume); }, ".bin or .acrt");
  volume.width = 0;
  ExpectInvalid([&] { ReadCosts(folder_.Write("v.bin", "x"), &volume); }, "width");
  ExpectInvalid([&] { WriteCostVolume(folder_.Path("v.dat"), RandomVolume()); }, ".bin or .acrt");
}

TEST_F(CostVolumeFile, HasItsShapeBesideIt) {
  const std::string path = folder_.Path("v.bin");
  EXPECT_FALSE(ReadCostVolumeShape(path));
  for (const char* dim : {"1\n70\n370\n1226\n", "70\n370\n1226"}) {
    folder_.Write("v.bin.dim", dim);
    const std::optional<CostVolume> shape = ReadCostVolumeShape(path);
    ASSERT_TRUE(shape);
    EXPECT_EQ(shape->disparities, 70);
    EXPECT_EQ(shape->height, 370);
    EXPECT_EQ(shape->width, 1226);
    EXPECT_EQ(shape->min_disparity, 0);
  }
  folder_.Write("v.bin.shape", "5 6 7 -8\n");
  EXPECT_EQ(ReadCostVolumeShape(path)->min_disparity, -8) << ".shape goes before .dim";
}

TEST_F(CostVolumeFile, RefusesMalformedShapes) {
  const struct {
    const char* name;
    const char* content;
    const char* message;
  } cases[] = {
      {"v.bin.dim", "", "empty"},
      {"v.bin.dim", "2\n70\n370\n1226\n", "1, disparities, height and width"},
      {"v.bin.dim", "370\n1226\n", "1, disparities, height and width"},
      {"v.bin.dim", "70\nx\n1226\n", "whole numbers"},
      {"v.bin.shape", "", "empty"},
      {"v.bin.shape", "5 6 7\n", "3 numbers found, four are expected"},
      {"v.bin.shape", "5 6 7 1.5\n", "whole numbers"},
      {"v.bin.shape", "0 6 7 0\n", "width of the cost volume is 0"},
      {"v.bin.shape", "5 -6 7 0\n", "height of the cost volume is -6"},
      {"v.bin.shape", "5 6 99999 0\n", "number of disparities of the cost volume is 99999"},
      {"v.bin.shape", "5 6 7 99999\n", "smallest disparity of the cost volume is 99999"},
      {"v.bin.shape", "99999999999999999999 6 7 0\n", "whole numbers"},
  };
  for (const auto& c : cases) {
    folder_.Write(c.name, c.content);
    ExpectInvalid([&] { ReadCostVolumeShape(folder_.Path("v.bin")); }, c.message);
  }
}

}  // namespace
}  // namespace stereo_sgmp
