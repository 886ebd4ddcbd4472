#include "prior/manhattan/manhattan_planes.h"

#include <gtest/gtest.h>

#include "prior/manhattan/projected_lines.h"

namespace stereo_sgmp {
namespace {

constexpr int kShrink = 4;
const cv::Size kCoarse(160, 120);

class ManhattanPlanesTest : public testing::Test {
 protected:
  // The coarse disparity of a plane of the full-size image.
  float CoarseDisparityOf(const DisparityPlane& plane, int x, int y) const {
    return static_cast<float>(scale_.ToCoarse(plane).At(x, y));
  }
  void Fill(const DisparityPlane& plane, const cv::Rect& where) {
    for (int y = where.y; y < where.y + where.height; ++y) {
      for (int x = where.x; x < where.x + where.width; ++x) {
        disparity_.at<float>(y, x) = CoarseDisparityOf(plane, x, y);
      }
    }
  }
  // A plane with the normal `direction` at `distance` metres.
  DisparityPlane PlaneOf(int direction, double distance) const {
    const Eigen::Vector3d normal = directions_.col(direction);
    const double side = normal.z() > 0.0 ? -1.0 : 1.0;
    return camera_.ToDisparity({side * normal, -distance});
  }
  static void ExpectEqual(const DisparityPlane& found, const DisparityPlane& expected,
                          double tolerance) {
    for (const double x : {0.0, 639.0}) {
      for (const double y : {0.0, 479.0}) {
        EXPECT_NEAR(found.At(x, y), expected.At(x, y), tolerance);
      }
    }
  }

  const StereoCamera camera_ = CameraOf640x480();
  const Eigen::Matrix3d directions_ = Frame(20, 10, 5);
  const CoarseScale scale_{kShrink, kShrink};
  ManhattanPlanes planes_{directions_, camera_, scale_};
  cv::Mat disparity_ = cv::Mat(kCoarse, CV_32FC1, cv::Scalar(0));
  cv::Mat confident_ = cv::Mat(kCoarse, CV_8UC1, cv::Scalar(255));
  cv::Mat orientations_ = cv::Mat(kCoarse, CV_16SC1, cv::Scalar(-1));
};

TEST_F(ManhattanPlanesTest, SegmentGivesThePlaneExactly) {
  const cv::Rect segment(90, 20, 50, 60);
  const DisparityPlane truth = PlaneOf(2, 3.0);
  Fill(truth, segment);
  orientations_(segment).setTo(2);
  planes_.AddSegments(orientations_, {disparity_, confident_});
  const auto found = planes_.Sorted();
  ASSERT_EQ(found.size(), 1U);
  ExpectEqual(found[0].found.plane, truth, 1e-4);
  EXPECT_EQ(found[0].found.support, segment.area());
  EXPECT_NEAR(found[0].found.residual, 0.0, 1e-4);
  const cv::Rect area(found[0].corner, found[0].area.size());
  EXPECT_EQ(area, cv::Rect(87, 17, 56, 66)) << "reaches over the lines around it";
  EXPECT_EQ(cv::countNonZero(found[0].area), area.area());
}

TEST_F(ManhattanPlanesTest, SegmentHoldsSeveralPlanes) {
  const cv::Rect segment(60, 20, 80, 60);
  const DisparityPlane far = PlaneOf(2, 4.0);
  const DisparityPlane near = PlaneOf(2, 2.0);
  Fill(far, segment);
  Fill(near, {60, 20, 30, 60});
  orientations_(segment).setTo(2);
  planes_.AddSegments(orientations_, {disparity_, confident_});
  const auto found = planes_.Sorted();
  ASSERT_EQ(found.size(), 2U);
  ExpectEqual(found[0].found.plane, far, 1e-4);
  ExpectEqual(found[1].found.plane, near, 1e-4);
  EXPECT_EQ(cv::countNonZero(found[0].area != found[1].area), 0) << "both all over the segment";
}

TEST_F(ManhattanPlanesTest, OnlyConfidentPixelsVote) {
  const cv::Rect segment(60, 20, 80, 60);
  Fill(PlaneOf(2, 4.0), segment);
  orientations_(segment).setTo(2);
  confident_.setTo(0);
  planes_.AddSegments(orientations_, {disparity_, confident_});
  EXPECT_TRUE(planes_.Sorted().empty());
}

TEST_F(ManhattanPlanesTest, SegmentsThatTouchCornersAreTwo) {
  const DisparityPlane truth = PlaneOf(2, 3.0);
  for (const cv::Rect& segment : {cv::Rect(60, 20, 20, 20), cv::Rect(80, 40, 30, 30)}) {
    Fill(truth, segment);
    orientations_(segment).setTo(2);
  }
  planes_.AddSegments(orientations_, {disparity_, confident_});
  const auto found = planes_.Sorted();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].found.support, 900);
  EXPECT_EQ(found[1].found.support, 400);
}

PlaneMap MapOf(const DisparityPlane& coarse, const cv::Rect& where, double rms) {
  PlaneMap map;
  map.planes.push_back({coarse, where.area(), rms});
  map.labels = cv::Mat(kCoarse, CV_16SC1, cv::Scalar(-1));
  map.labels(where).setTo(0);
  return map;
}

TEST_F(ManhattanPlanesTest, HypothesisTurnsToTheDirectionItNearlyFaces) {
  const cv::Rect where(60, 40, 20, 20);
  const DisparityPlane truth = PlaneOf(2, 3.0);
  Fill(truth, where);
  // Tilted by four degrees about the middle of the window, as noise tilts it.
  DisparityPlane tilted = scale_.ToCoarse(truth);
  tilted.a += 0.0025;
  tilted.c -= 0.0025 * 70;
  planes_.AddHypotheses(MapOf(tilted, where, 0.02), disparity_);
  const auto found = planes_.Sorted();
  ASSERT_EQ(found.size(), 1U);
  ExpectEqual(found[0].found.plane, truth, 1e-4);
  EXPECT_EQ(found[0].found.support, 400);
  EXPECT_EQ(found[0].corner, where.tl());
  EXPECT_EQ(cv::countNonZero(found[0].area), 400);
}

TEST_F(ManhattanPlanesTest, HypothesisStaysWhereTheDisparitiesContradict) {
  // Tilted by eight degrees, and large enough for it to show.
  const cv::Rect where(20, 10, 120, 100);
  DisparityPlane tilted = PlaneOf(2, 2.0);
  tilted.a += 0.008;
  Fill(tilted, where);
  planes_.AddHypotheses(MapOf(scale_.ToCoarse(tilted), where, 0.0), disparity_);
  ASSERT_EQ(planes_.Sorted().size(), 1U);
  ExpectEqual(planes_.Sorted()[0].found.plane, tilted, 1e-6);
}

TEST_F(ManhattanPlanesTest, HypothesisStaysWhereItFacesNoDirection) {
  const cv::Rect where(60, 40, 20, 20);
  const Eigen::Vector3d between = -(directions_.col(2) + directions_.col(0)).normalized();
  const DisparityPlane truth = camera_.ToDisparity({between, -3.0});
  Fill(truth, where);
  planes_.AddHypotheses(MapOf(scale_.ToCoarse(truth), where, 5.0), disparity_);
  ASSERT_EQ(planes_.Sorted().size(), 1U);
  ExpectEqual(planes_.Sorted()[0].found.plane, truth, 1e-6);
}

}  // namespace
}  // namespace stereo_sgmp
