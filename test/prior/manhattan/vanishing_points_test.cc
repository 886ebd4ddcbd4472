#include "prior/manhattan/vanishing_points.h"

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "prior/manhattan/projected_lines.h"

namespace stereo_sgmp {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

class Random {
 public:
  double Uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits_()) / 4294967296.0);
  }

 private:
  std::mt19937 bits_{7};
};

// Lines of 40 to 120 pixels along a direction, their ends off by up to half a pixel.
void AddLines(const Vector3d& direction, int count, Random* random,
              std::vector<LineSegment>* lines) {
  const StereoCamera camera = CameraOf640x480();
  while (count > 0) {
    const double z = random->Uniform(2.0, 6.0);
    const Vector3d start(z * random->Uniform(-0.6, 0.6), z * random->Uniform(-0.5, 0.5), z);
    const Vector3d end = start + random->Uniform(0.5, 1.5) * direction;
    LineSegment line = Seen(camera, start, end);
    if (end.z() < 0.5 || line.Length() < 40.0 || line.Length() > 120.0) continue;
    line.start += Vector2d(random->Uniform(-0.5, 0.5), random->Uniform(-0.5, 0.5));
    line.end += Vector2d(random->Uniform(-0.5, 0.5), random->Uniform(-0.5, 0.5));
    lines->push_back(line);
    --count;
  }
}

void AddClutter(int count, Random* random, std::vector<LineSegment>* lines) {
  for (int i = 0; i < count; ++i) {
    const Vector2d start(random->Uniform(0, 560), random->Uniform(0, 400));
    const double angle = random->Uniform(0.0, 6.28);
    lines->push_back({start, start + 80.0 * Vector2d(std::cos(angle), std::sin(angle))});
  }
}

double DegreesBetween(const Matrix3d& a, const Matrix3d& b) {
  return Eigen::AngleAxisd(Matrix3d(a.transpose() * b)).angle() * 57.29577951308232;
}

struct Pose {
  double yaw, pitch, roll;
};

class FrameOf : public testing::TestWithParam<Pose> {};

TEST_P(FrameOf, IsWithinHalfADegreeAmongClutter) {
  const Matrix3d truth = Frame(GetParam().yaw, GetParam().pitch, GetParam().roll);
  Random random;
  std::vector<LineSegment> lines;
  for (int c = 0; c < 3; ++c) AddLines(truth.col(c), 25, &random, &lines);
  AddClutter(40, &random, &lines);
  const auto frame = FindManhattanFrame(lines, CameraOf640x480());
  ASSERT_TRUE(frame.has_value());
  EXPECT_LT(DegreesBetween(frame->directions, truth), 0.5) << frame->directions;
  ASSERT_EQ(frame->classes.size(), lines.size());
  int right = 0;
  for (std::size_t i = 0; i < 75; ++i) right += frame->classes[i] == static_cast<int>(i / 25);
  EXPECT_GE(right, 70);
  int clutter = 0;
  for (std::size_t i = 75; i < lines.size(); ++i) clutter += frame->classes[i] < 0;
  EXPECT_GE(clutter, 30);
}

INSTANTIATE_TEST_SUITE_P(Poses, FrameOf,
                         testing::Values(Pose{0, 0, 0}, Pose{20, 0, 0}, Pose{-40, 0, 0},
                                         Pose{25, 20, 0}, Pose{-15, -10, 12}, Pose{35, 25, -30}));

TEST(VanishingPoints, IsARotationWithItsAxesInOrder) {
  Random random;
  std::vector<LineSegment> lines;
  const Matrix3d truth = Frame(30.0, 10.0, 5.0);
  for (int c = 0; c < 3; ++c) AddLines(-truth.col(2 - c), 20, &random, &lines);
  const auto frame = FindManhattanFrame(lines, CameraOf640x480());
  ASSERT_TRUE(frame.has_value());
  EXPECT_NEAR(frame->directions.determinant(), 1.0, 1e-9);
  EXPECT_GT(frame->directions(1, 1), 0.8) << "the second points down";
  EXPECT_GT(frame->directions(2, 2), 0.8) << "the third points forward";
}

TEST(VanishingPoints, ClutterHasNoFrame) {
  Random random;
  std::vector<LineSegment> lines;
  AddClutter(150, &random, &lines);
  EXPECT_FALSE(FindManhattanFrame(lines, CameraOf640x480()).has_value());
}

TEST(VanishingPoints, OneDirectionAloneIsNoFrame) {
  Random random;
  std::vector<LineSegment> lines;
  AddLines(Vector3d::UnitY(), 60, &random, &lines);
  EXPECT_FALSE(FindManhattanFrame(lines, CameraOf640x480()).has_value());
}

TEST(VanishingPoints, TwoDirectionsAloneAreNoFrame) {
  Random random;
  std::vector<LineSegment> lines;
  for (int c = 0; c < 2; ++c) AddLines(Frame(20, 0, 0).col(c), 40, &random, &lines);
  EXPECT_FALSE(FindManhattanFrame(lines, CameraOf640x480()).has_value());
}

TEST(VanishingPoints, OneDirectionWithFewOthersIsNoFrame) {
  Random random;
  std::vector<LineSegment> lines;
  for (int c = 0; c < 3; ++c) AddLines(Frame(20, 0, 0).col(c), c == 1 ? 60 : 3, &random, &lines);
  EXPECT_FALSE(FindManhattanFrame(lines, CameraOf640x480()).has_value());
}

TEST(VanishingPoints, MostOfTheLinesHaveToFit) {
  Random random;
  std::vector<LineSegment> lines;
  for (int c = 0; c < 3; ++c) AddLines(Frame(20, 0, 0).col(c), 20, &random, &lines);
  AddClutter(120, &random, &lines);
  EXPECT_FALSE(FindManhattanFrame(lines, CameraOf640x480()).has_value());
}

TEST(VanishingPoints, FewLinesHaveNoFrame) {
  const LineSegment line{{0.0, 0.0}, {100.0, 0.0}};
  EXPECT_FALSE(FindManhattanFrame({}, CameraOf640x480()).has_value());
  EXPECT_FALSE(FindManhattanFrame({line, line}, CameraOf640x480()).has_value());
  EXPECT_FALSE(FindManhattanFrame({line, line, line, line}, CameraOf640x480()).has_value())
      << "lines in one have no intersection";
}

TEST(VanishingPoints, SameFromRunToRun) {
  Random random;
  std::vector<LineSegment> lines;
  for (int c = 0; c < 3; ++c) AddLines(Frame(20, 5, 0).col(c), 30, &random, &lines);
  const auto one = FindManhattanFrame(lines, CameraOf640x480());
  const auto two = FindManhattanFrame(lines, CameraOf640x480());
  ASSERT_TRUE(one.has_value() && two.has_value());
  EXPECT_EQ(one->directions, two->directions);
}

}  // namespace
}  // namespace stereo_sgmp
