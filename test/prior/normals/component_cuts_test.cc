#include "prior/normals/component_cuts.h"

#include <gtest/gtest.h>

#include "prior/normals/normal_integration.h"

namespace stereo_sgmp {
namespace {

const cv::Size kSize(40, 30);
constexpr int kCell = 5;

// One component with two labels that meet at x = 20.
class CutComponentsTest : public testing::Test {
 protected:
  CutComponentsTest() { label_.colRange(20, 40).setTo(1); }

  cv::Mat_<int> Cut() const { return CutComponents(component_, label_, edges_); }

  cv::Mat_<int> component_{kSize, 1 + kCell* IntegratedNormals::kCellArea};
  cv::Mat_<schar> label_{kSize, schar{0}};
  cv::Mat_<uchar> edges_{kSize, uchar{10}};
};

TEST_F(CutComponentsTest, CutsWhereLabelsMeetAtAnEdge) {
  edges_.colRange(19, 21).setTo(14);
  const cv::Mat_<int> cut = Cut();
  EXPECT_NE(cut(0, 0), cut(0, 39));
  EXPECT_EQ(IntegratedNormals::CellOf(cut(0, 39)), kCell);
  EXPECT_EQ(cv::countNonZero(cut.colRange(0, 20) != cut(0, 0)), 0);
  EXPECT_EQ(cv::countNonZero(cut.colRange(20, 40) != cut(0, 39)), 0);
}

TEST_F(CutComponentsTest, KeepsTogetherWhatMeetsWhereTheImageHardlyChangesMoreThanElsewhere) {
  EXPECT_EQ(cv::countNonZero(Cut() != Cut()(0, 0)), 0);
  edges_.colRange(19, 21).setTo(12);
  EXPECT_EQ(cv::countNonZero(Cut() != Cut()(0, 0)), 0);
  edges_.colRange(19, 21).setTo(30);
  edges_.colRange(5, 10).setTo(120);
  EXPECT_EQ(cv::countNonZero(Cut() != Cut()(0, 0)), 0);
}

// 2 is told apart from 1, but not from 0.
TEST_F(CutComponentsTest, AThirdLabelGoesWithTheOneItIsNotToldApartFrom) {
  edges_.colRange(19, 21).setTo(14);
  label_(cv::Rect(0, 10, 20, 20)).setTo(2);
  const cv::Mat_<int> cut = Cut();
  EXPECT_EQ(cv::countNonZero(cut.colRange(0, 20) != cut(0, 0)), 0);
  EXPECT_EQ(cv::countNonZero(cut.colRange(20, 40) == cut(0, 0)), 0);
}

TEST_F(CutComponentsTest, LeavesUnknownPixelsAndOtherComponentsAsTheyAre) {
  component_.row(3).setTo(0);
  component_.row(4).setTo(1);
  const cv::Mat_<int> cut = Cut();
  EXPECT_EQ(cv::countNonZero(cut.row(3)), 0);
  EXPECT_EQ(IntegratedNormals::CellOf(cut(4, 0)), 0);
  EXPECT_NE(cut(4, 0), cut(5, 0));
}

}  // namespace
}  // namespace stereo_sgmp
