#include "prior/plane_set_painter.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

std::vector<int> PlanesAt(const PlaneSets& sets, cv::Point pixel) {
  const PlaneSet& set = sets.sets[sets.ids.at<std::uint16_t>(pixel)];
  return {set.planes.begin(), set.planes.begin() + set.count};
}

TEST(PlaneSetPainter, HoldsPlanesWhereTheirAreasAre) {
  PlaneSetPainter painter;
  painter.Start({6, 4});
  painter.Paint(7, cv::Mat(2, 3, CV_8UC1, cv::Scalar(255)), {1, 1});
  painter.Paint(3, cv::Mat(1, 2, CV_8UC1, cv::Scalar(1)), {3, 2});
  const PlaneSets& sets = painter.sets();
  EXPECT_EQ(PlanesAt(sets, {0, 0}), std::vector<int>());
  EXPECT_EQ(PlanesAt(sets, {1, 1}), std::vector<int>({7}));
  EXPECT_EQ(PlanesAt(sets, {3, 2}), std::vector<int>({7, 3})) << "in the order painted";
  EXPECT_EQ(PlanesAt(sets, {4, 2}), std::vector<int>({3}));
}

TEST(PlaneSetPainter, PixelsThatAreFullStay) {
  PlaneSetPainter painter;
  painter.Start({1, 1});
  const cv::Mat pixel(1, 1, CV_8UC1, cv::Scalar(255));
  for (std::int16_t i = 0; i < PlaneSet::kMaxFound + 2; ++i) painter.Paint(i, pixel, {0, 0});
  const std::vector<int> planes = PlanesAt(painter.sets(), {0, 0});
  ASSERT_EQ(planes.size(), static_cast<std::size_t>(PlaneSet::kMaxFound));
  EXPECT_EQ(planes.back(), PlaneSet::kMaxFound - 1);
}

TEST(PlaneSetPainter, FillEmptyGivesOnePlaneToPixelsWithoutAny) {
  PlaneSetPainter painter;
  painter.Start({5, 1});
  painter.Paint(7, cv::Mat(1, 2, CV_8UC1, cv::Scalar(255)), {0, 0});
  painter.FillEmpty((cv::Mat_<std::int16_t>(1, 5) << 3, -1, 3, -1, 3));
  const PlaneSets& sets = painter.sets();
  EXPECT_EQ(PlanesAt(sets, {0, 0}), std::vector<int>({7})) << "not empty";
  EXPECT_EQ(PlanesAt(sets, {1, 0}), std::vector<int>({7}));
  EXPECT_EQ(PlanesAt(sets, {2, 0}), std::vector<int>({3}));
  EXPECT_EQ(PlanesAt(sets, {3, 0}), std::vector<int>()) << "no label";
  EXPECT_EQ(PlanesAt(sets, {4, 0}), std::vector<int>({3}));
  EXPECT_EQ(sets.sets.size(), 3U) << "none, 7 and 3";
}

TEST(PlaneSetPainter, FillEmptyMayFollowAnotherImage) {
  PlaneSetPainter painter;
  for (const int label : {4, 0}) {
    painter.Start({2, 1});
    painter.FillEmpty(cv::Mat(1, 2, CV_16SC1, cv::Scalar(label)));
    EXPECT_EQ(PlanesAt(painter.sets(), {1, 0}), std::vector<int>({label}));
    EXPECT_EQ(painter.sets().sets.size(), 2U);
  }
}

TEST(PlaneSetPainter, StartForgetsTheLastImage) {
  PlaneSetPainter painter;
  painter.Start({2, 2});
  painter.Paint(0, cv::Mat(2, 2, CV_8UC1, cv::Scalar(255)), {0, 0});
  painter.Start({3, 2});
  EXPECT_EQ(painter.sets().sets.size(), 1U);
  EXPECT_EQ(painter.sets().ids.size(), cv::Size(3, 2));
  EXPECT_EQ(cv::countNonZero(painter.sets().ids), 0);
}

}  // namespace
}  // namespace stereo_sgmp
