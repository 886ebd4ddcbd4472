#include "prior/steering_planes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "prior/unpack_jumps.h"

namespace stereo_sgmp {
namespace {

constexpr PathStep kSteps[] = {{1, 0}, {-1, 0},  {0, 1},  {0, -1},
                               {1, 1}, {-1, -1}, {1, -1}, {-1, 1}};
constexpr PathStep kRight{1, 0};
constexpr int kWidth = 160;
constexpr int kMinDisparity = -10;

VolumeShape Shape() {
  VolumeShape shape;
  shape.width = kWidth;
  shape.height = 20;
  shape.disparities = 96;
  shape.min_disparity = kMinDisparity;
  return shape;
}

PriorOptions OptionsOf(double attraction, double min_slope) {
  PriorOptions options;
  options.attraction = attraction;
  options.min_slope = min_slope;
  return options;
}

// All planes everywhere.
PlaneSets OneSet(std::size_t planes) {
  PlaneSets sets;
  sets.sets.resize(2);
  for (std::size_t i = 0; i < planes; ++i) {
    sets.sets[1].planes[sets.sets[1].count++] = static_cast<std::int16_t>(i);
  }
  sets.ids = cv::Mat(5, 40, CV_16UC1, cv::Scalar(1));
  return sets;
}

int JumpAt(const JumpRow& row, int x, int disparity) {
  const auto entry = static_cast<std::size_t>(x);
  if (row.jump[entry] != JumpRow::kVaries) {
    const bool moves = row.begin[entry] <= disparity && disparity < row.end[entry];
    return moves ? row.jump[entry] : 0;
  }
  for (int s = 0; s < row.segment_count[entry]; ++s) {
    const auto at = static_cast<std::size_t>(row.first_segment[entry] + s);
    if (disparity < row.segments[at].end) return row.segments[at].jump;
  }
  ADD_FAILURE() << "segments end before " << disparity;
  return 0;
}

int Rounded(const DisparityPlane& plane, int x, int y) {
  return static_cast<int>(std::floor(plane.At(x, y) + 0.5));
}

// How far above the plane a path to the right is at each pixel, which starts `offset` above it.
std::vector<int> HeightsAlongRow(const OrientationPrior& prior, const DisparityPlane& plane,
                                 int offset) {
  constexpr int kRow = 7;
  JumpRow row;
  prior.Jumps(kRow, 0, kWidth, kRight, &row);
  int disparity = Rounded(plane, 0, kRow) + offset;
  std::vector<int> heights{offset};
  for (int x = 1; x < kWidth; ++x) {
    disparity += JumpAt(row, x, disparity - kMinDisparity);
    heights.push_back(disparity - Rounded(plane, x, kRow));
  }
  return heights;
}

void ExpectSameJumps(const OrientationPrior& a, const OrientationPrior& b) {
  JumpRow of_a;
  JumpRow of_b;
  for (const PathStep step : kSteps) {
    for (int y = 0; y < Shape().height; ++y) {
      a.Jumps(y, 0, kWidth, step, &of_a);
      b.Jumps(y, 0, kWidth, step, &of_b);
      for (int x = 0; x < kWidth; ++x) {
        for (int d = 0; d < Shape().disparities; ++d) {
          ASSERT_EQ(JumpAt(of_a, x, d), JumpAt(of_b, x, d)) << x << " " << y << " " << d;
        }
      }
    }
  }
}

const std::vector<DisparityPlane> kThree = {
    {0.11, -0.07, 10.3}, {-0.2, 0.02, 60.8}, {0.03, 0.0, 30.0}};

TEST(SteeringPlanes, WithoutAttractionAndMinSlopeFollowThePlanesAsTheyAre) {
  for (const JumpPolicy policy : {JumpPolicy::kSameSurface, JumpPolicy::kLiteral}) {
    PriorOptions options = OptionsOf(0.0, 0.0);
    options.jump_policy = policy;
    PlaneSetPrior expected;
    expected.Assign(kThree, OneSet(3), Shape(), policy);
    SteeringPlanes steering;
    steering.Assign(options, kThree, OneSet(3), Shape());
    ExpectSameJumps(*steering.attracting(), expected);
    ExpectSameJumps(*steering.parallel(), expected);
  }
}

TEST(SteeringPlanes, TheSecondRoundHasNoAttraction) {
  SteeringPlanes with;
  SteeringPlanes without;
  with.Assign(OptionsOf(0.25, 0.05), kThree, OneSet(3), Shape());
  without.Assign(OptionsOf(0.0, 0.05), kThree, OneSet(3), Shape());
  ExpectSameJumps(*with.parallel(), *without.attracting());
}

TEST(SteeringPlanes, FlatPlanesGiveNoJumps) {
  const std::vector<DisparityPlane> flat = {{0.03, -0.02, 20.0}};  // a slope of 0.036
  JumpRow row;
  for (const double min_slope : {0.037, 0.035}) {
    SteeringPlanes steering;
    steering.Assign(OptionsOf(0.0, min_slope), flat, OneSet(1), Shape());
    steering.attracting()->Jumps(3, 0, kWidth, kRight, &row);
    int climbed = 0;
    for (std::size_t i = 0; i < row.jump.size(); ++i) climbed += row.jump[i];
    EXPECT_EQ(climbed, min_slope > 0.036 ? 0 : 5) << min_slope;
  }
}

TEST(SteeringPlanes, AFlatPlaneIsItselfInTheMiddleOfTheImage) {
  // Its value shows in where the cell of the slanted plane begins.
  const std::vector<DisparityPlane> planes = {{0.02, 0.0, 10.0}, {0.2, 0.0, 14.0}};
  SteeringPlanes steering;
  steering.Assign(OptionsOf(0.0, 0.04), planes, OneSet(2), Shape());
  JumpRow row;
  steering.attracting()->Jumps(3, 0, kWidth, kRight, &row);
  // From x = 2 to 3 the slanted plane steps from 14 to 15; the flat one is 10 + 0.02 * 80 = 11.6,
  // so that 14 is the first disparity nearer to the slanted one.
  EXPECT_EQ(JumpAt(row, 3, 13 - kMinDisparity), 0);
  EXPECT_EQ(JumpAt(row, 3, 14 - kMinDisparity), 1);
}

class SteeringTo : public testing::TestWithParam<double> {};  // slope

TEST_P(SteeringTo, AttractionLeadsPathsBesideThePlaneOntoIt) {
  const DisparityPlane plane{GetParam(), 0.03, 40.2};
  SteeringPlanes steering;
  steering.Assign(OptionsOf(0.25, 0.0), {plane}, OneSet(1), Shape());
  const auto period = static_cast<std::size_t>(std::ceil(1.0 / std::abs(GetParam())));
  for (const int offset : {-1, 1}) {
    SCOPED_TRACE(offset);
    const std::vector<int> heights = HeightsAlongRow(*steering.attracting(), plane, offset);
    for (std::size_t x = period; x < heights.size(); ++x) ASSERT_EQ(heights[x], 0) << x;
    EXPECT_EQ(HeightsAlongRow(*steering.parallel(), plane, offset),
              std::vector<int>(kWidth, offset));
  }
}

TEST_P(SteeringTo, PathsOnThePlaneStayOnIt) {
  const DisparityPlane plane{GetParam(), 0.03, 40.2};
  SteeringPlanes steering;
  steering.Assign(OptionsOf(0.25, 0.0), {plane}, OneSet(1), Shape());
  EXPECT_EQ(HeightsAlongRow(*steering.attracting(), plane, 0), std::vector<int>(kWidth, 0));
}

TEST_P(SteeringTo, AttractionTakesPathsOneDisparityNearerForEachThatThePlaneChangesBy) {
  const DisparityPlane plane{GetParam(), 0.03, 40.2};
  SteeringPlanes steering;
  steering.Assign(OptionsOf(0.25, 0.0), {plane}, OneSet(1), Shape());
  const double period = 1.0 / std::abs(GetParam());
  for (const int offset : {-5, -3, 3, 5}) {
    SCOPED_TRACE(offset);
    const std::vector<int> heights = HeightsAlongRow(*steering.attracting(), plane, offset);
    for (std::size_t x = 0; x < heights.size(); ++x) {
      const double steps = std::min(static_cast<double>(x) / period, std::abs(1.0 * offset));
      ASSERT_NEAR(std::abs(heights[x]), std::abs(offset) - steps, 1.0) << x;
    }
    EXPECT_EQ(HeightsAlongRow(*steering.parallel(), plane, offset),
              std::vector<int>(kWidth, offset));
  }
}

INSTANTIATE_TEST_SUITE_P(Slopes, SteeringTo, testing::Values(0.05, -0.05, 0.171, -0.241));

TEST(SteeringPlanes, NothingFoundGivesNoPrior) {
  SteeringPlanes steering;
  steering.Assign(OptionsOf(0.25, 0.04), kThree, OneSet(3), Shape());
  steering.Assign(OptionsOf(0.25, 0.04), {}, OneSet(0), Shape());
  EXPECT_EQ(steering.attracting(), nullptr);
  EXPECT_EQ(steering.parallel(), nullptr);
}

TEST(SteeringPlanes, AsManyPlanesAsAPixelHoldsAttractTogether) {
  std::vector<DisparityPlane> planes;
  for (int i = 0; i < PlaneSet::kMaxFound; ++i) planes.push_back({0.1, 0.0, 9.0 * i - 4.97});
  SteeringPlanes steering;
  steering.Assign(OptionsOf(0.25, 0.04), planes, OneSet(planes.size()), Shape());
  for (const DisparityPlane& plane : planes) {
    EXPECT_EQ(HeightsAlongRow(*steering.attracting(), plane, 0), std::vector<int>(kWidth, 0));
    EXPECT_EQ(HeightsAlongRow(*steering.attracting(), plane, 1)[10], 0);
    EXPECT_EQ(HeightsAlongRow(*steering.attracting(), plane, -1)[10], 0);
  }
}

}  // namespace
}  // namespace stereo_sgmp
