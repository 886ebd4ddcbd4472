#include "prior/manhattan/orientation_map.h"

#include <array>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "prior/manhattan/projected_lines.h"

namespace stereo_sgmp {
namespace {

using Eigen::Vector3d;

constexpr int kShrink = 4;
const cv::Size kFull(640, 480);
const cv::Size kSmall(kFull.width / kShrink, kFull.height / kShrink);

// The twelve edges of a box, given by two corners in the axes of the world.
class Box {
 public:
  Box(const Eigen::Matrix3d& world, const Vector3d& low, const Vector3d& high)
      : world_(world), corners_{low, high} {
    frame_.directions = world;
    for (int axis = 0; axis < 3; ++axis) {
      for (int edge = 0; edge < 4; ++edge) AddEdge(axis, edge);
    }
  }

  const std::vector<LineSegment>& lines() const { return lines_; }
  const ManhattanFrame& frame() const { return frame_; }

  std::int16_t NormalAt(const cv::Mat& map, const Vector3d& point) const {
    const Eigen::Vector2d p = Projected(CameraOf640x480(), world_ * point) / kShrink;
    return map.at<std::int16_t>(static_cast<int>(p.y()), static_cast<int>(p.x()));
  }

  void Remove(int axis) {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (i / 4 == static_cast<std::size_t>(axis)) frame_.classes[i] = -1;
    }
  }

 private:
  void AddEdge(int axis, int edge) {
    Vector3d start = corners_[0];
    start[(axis + 1) % 3] = corners_[static_cast<std::size_t>(edge % 2)][(axis + 1) % 3];
    start[(axis + 2) % 3] = corners_[static_cast<std::size_t>(edge / 2)][(axis + 2) % 3];
    Vector3d end = start;
    end[axis] = corners_[1][axis];
    lines_.push_back(Seen(CameraOf640x480(), world_ * start, world_ * end));
    frame_.classes.push_back(static_cast<std::int8_t>(axis));
  }

  Eigen::Matrix3d world_;
  std::array<Vector3d, 2> corners_;
  std::vector<LineSegment> lines_;
  ManhattanFrame frame_;
};

// Looking into a room whose far wall, floor, ceiling and side walls are all seen.
TEST(OrientationMap, WallsOfARoom) {
  for (const Eigen::Matrix3d& world : {Frame(0, 0, 0), Frame(8, 4, 5)}) {
    const Box room(world, {-1.5, -1.2, 3.0}, {1.5, 1.2, 6.0});
    const cv::Mat map =
        MapOrientations(room.lines(), room.frame(), CameraOf640x480(), kFull, kSmall);
    ASSERT_EQ(map.type(), CV_16SC1);
    ASSERT_EQ(map.size(), kSmall);
    EXPECT_EQ(room.NormalAt(map, {-1.5, 0.1, 4.0}), 0);
    EXPECT_EQ(room.NormalAt(map, {1.5, 0.1, 4.0}), 0);
    EXPECT_EQ(room.NormalAt(map, {0.1, -1.2, 4.0}), 1);
    EXPECT_EQ(room.NormalAt(map, {0.1, 1.2, 4.0}), 1);
    EXPECT_EQ(room.NormalAt(map, {0.1, 0.1, 6.0}), 2);
  }
}

TEST(OrientationMap, NothingWithLinesOfOneDirectionOnly) {
  Box room(Frame(0, 0, 0), {-1.5, -1.2, 3.0}, {1.5, 1.2, 6.0});
  room.Remove(0);
  room.Remove(2);
  const cv::Mat map = MapOrientations(room.lines(), room.frame(), CameraOf640x480(), kFull, kSmall);
  EXPECT_EQ(cv::countNonZero(map != -1), 0);
}

// A wall that faces the camera: a horizontal and an upright edge sweep over all of it, until a
// line that runs away from the camera, which can't lie on the wall, stands in the way.
TEST(OrientationMap, LinesOfTheNormalsDirectionStopTheSweep) {
  const StereoCamera camera = CameraOf640x480();
  ManhattanFrame frame;
  frame.directions = Eigen::Matrix3d::Identity();
  frame.classes = {0, 1, 2};
  const std::vector<LineSegment> lines = {{{100.0, 100.0}, {500.0, 100.0}},
                                          {{100.0, 100.0}, {100.0, 400.0}},
                                          Seen(camera, {0.9, 0.3, 5.0}, {0.9, 0.3, 3.0})};
  const cv::Mat map = MapOrientations(lines, frame, camera, kFull, kSmall);
  // The third line is seen from (400, 280) to (460, 300).
  EXPECT_EQ(map.at<std::int16_t>(350 / kShrink, 380 / kShrink), 2) << "beside the line";
  EXPECT_EQ(map.at<std::int16_t>(200 / kShrink, 430 / kShrink), 2) << "before the line";
  EXPECT_EQ(map.at<std::int16_t>(350 / kShrink, 430 / kShrink), -1) << "behind the line";
}

// The first two lines bound a wall that faces the camera, the last two one that faces right.
TEST(OrientationMap, PixelsWithTwoNormalsHaveNone) {
  const StereoCamera camera = CameraOf640x480();
  const std::vector<LineSegment> lines = {{{100.0, 100.0}, {500.0, 100.0}},
                                          {{100.0, 100.0}, {100.0, 400.0}},
                                          Seen(camera, {-1.0, 0.3, 4.0}, {-1.0, 0.3, 2.5})};
  const cv::Point pixel(150 / kShrink, 250 / kShrink);
  ManhattanFrame frame;
  frame.directions = Eigen::Matrix3d::Identity();
  frame.classes = {0, 1, -1};
  EXPECT_EQ(MapOrientations(lines, frame, camera, kFull, kSmall).at<std::int16_t>(pixel), 2);
  frame.classes = {-1, 1, 2};
  EXPECT_EQ(MapOrientations(lines, frame, camera, kFull, kSmall).at<std::int16_t>(pixel), 0);
  frame.classes = {0, 1, 2};
  EXPECT_EQ(MapOrientations(lines, frame, camera, kFull, kSmall).at<std::int16_t>(pixel), -1);
}

// The front edge of the floor doesn't sweep on beyond the horizon, where the ceiling has a line.
TEST(OrientationMap, PlanesEndAtTheirHorizon) {
  const StereoCamera camera = CameraOf640x480();
  ManhattanFrame frame;
  frame.directions = Eigen::Matrix3d::Identity();
  frame.classes = {0, 2, 2};
  const std::vector<LineSegment> lines = {Seen(camera, {-3.0, 1.0, 3.0}, {3.0, 1.0, 3.0}),
                                          Seen(camera, {1.0, 1.0, 2.5}, {1.0, 1.0, 20.0}),
                                          Seen(camera, {-1.0, -1.0, 2.5}, {-1.0, -1.0, 20.0})};
  const cv::Mat map = MapOrientations(lines, frame, camera, kFull, kSmall);
  EXPECT_EQ(map.at<std::int16_t>(350 / kShrink, 200 / kShrink), 1);
  EXPECT_EQ(cv::countNonZero(map.rowRange(0, 250 / kShrink) != -1), 0);
}

}  // namespace
}  // namespace stereo_sgmp
