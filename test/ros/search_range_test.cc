#include "ros/search_range.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

StereoCamera Camera() {
  StereoCamera camera;
  camera.focal_length = 500.0;
  camera.baseline = 0.1;
  camera.doffs = 2.0;
  return camera;
}

NodeletOptions Depths(double nearest, double farthest) {
  NodeletOptions options;
  options.match.min_disparity = 3;
  options.match.num_disparities = 40;
  options.stream.min_depth = nearest;
  options.stream.max_depth = farthest;
  return options;
}

int LastDisparity(const Options& options) {
  return options.min_disparity + options.num_disparities - 1;
}

TEST(SearchRangeTest, IsThatOfTheDisparitiesWithoutDepths) {
  const SearchRange range = ResolveSearchRange(Depths(0, 0), Camera(), 640);
  EXPECT_EQ(range.options.min_disparity, 3);
  EXPECT_EQ(range.options.num_disparities, 40);
  EXPECT_EQ(range.problem, "");
}

TEST(SearchRangeTest, CoversTheDepths) {
  const StereoCamera camera = Camera();
  const SearchRange range = ResolveSearchRange(Depths(0.5, 10.0), camera, 640);
  EXPECT_LE(camera.DepthOf(LastDisparity(range.options)), 0.5);
  EXPECT_GE(camera.DepthOf(range.options.min_disparity), 10.0);
  EXPECT_LE(range.options.num_disparities, 97);
  EXPECT_EQ(range.problem, "");
}

TEST(SearchRangeTest, NearestDepthAloneReachesToInfinity) {
  const SearchRange range = ResolveSearchRange(Depths(0.5, 0), Camera(), 640);
  EXPECT_EQ(range.options.min_disparity, -2);
  EXPECT_EQ(LastDisparity(range.options), 98);
}

TEST(SearchRangeTest, FarthestDepthAloneKeepsTheNumber) {
  const SearchRange range = ResolveSearchRange(Depths(0, 10.0), Camera(), 640);
  EXPECT_EQ(range.options.min_disparity, 3);  // 500 * 0.1 / 10 - 2
  EXPECT_EQ(range.options.num_disparities, 40);
}

TEST(SearchRangeTest, KeepsToWhatCanBeSearchedAndSaysSo) {
  const SearchRange range = ResolveSearchRange(Depths(0.1, 0), Camera(), 320);
  EXPECT_EQ(range.options.num_disparities, 320);
  EXPECT_THAT(range.problem, testing::HasSubstr("min_depth 0.1 m takes 501 disparities; expected "
                                                "at most 320; the nearest depth is 0.1567"));
}

}  // namespace
}  // namespace stereo_sgmp
