#include "prior/nearest_planes.h"

#include <cstdint>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

TEST(NearestPlanes, TakesTheNearestOfThoseThatHold) {
  PlaneSets sets;
  sets.sets.resize(3);
  sets.sets[1].count = 1;
  sets.sets[1].planes = {1};
  sets.sets[2].count = 2;
  sets.sets[2].planes = {0, 1};
  sets.ids = (cv::Mat_<std::uint16_t>(1, 4) << 0, 1, 2, 2);
  const std::vector<DisparityPlane> planes = {{1.0, 0.0, 0.0}, {0.0, 0.0, 8.0}};
  const cv::Mat disparity = (cv::Mat_<float>(1, 4) << 8.0F, 1.0F, 4.0F, 6.5F);
  cv::Mat labels;
  LabelNearestPlanes(sets, planes, disparity, &labels);
  ASSERT_EQ(labels.type(), CV_16SC1);
  EXPECT_EQ(labels.at<std::int16_t>(0, 0), -1) << "no plane holds here";
  EXPECT_EQ(labels.at<std::int16_t>(0, 1), 1) << "plane 0 is nearer, but does not hold";
  EXPECT_EQ(labels.at<std::int16_t>(0, 2), 0) << "2 against 8";
  EXPECT_EQ(labels.at<std::int16_t>(0, 3), 1) << "3 against 8";
}

}  // namespace
}  // namespace stereo_sgmp
