#include "evaluation/completeness.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

CompletenessCurve Curve(const std::vector<bool>& bad, const std::vector<float>& uncertainty) {
  const int count = static_cast<int>(bad.size());
  cv::Mat_<std::uint8_t> bad_mask(1, count);
  for (int i = 0; i < count; ++i) bad_mask(0, i) = bad[static_cast<std::size_t>(i)] ? 255 : 0;
  const cv::Mat evaluated(1, count, CV_8U, cv::Scalar(255));
  return {bad_mask, evaluated, cv::Mat(uncertainty).reshape(1, 1)};
}

TEST(CompletenessCurve, TakesTheMostCertainPixelsFirst) {
  const CompletenessCurve curve = Curve({true, false, false, true}, {3, 1, 2, 4});
  EXPECT_DOUBLE_EQ(curve.ErrorAt(0.25), 0);
  EXPECT_DOUBLE_EQ(curve.ErrorAt(0.5), 0);
  EXPECT_DOUBLE_EQ(curve.ErrorAt(0.75), 100.0 / 3);
  EXPECT_DOUBLE_EQ(curve.ErrorAt(1.0), 50);
  EXPECT_DOUBLE_EQ(curve.Area(), 100 * (0 + 0 + 1.0 / 3 + 2.0 / 4) / 4);
}

TEST(CompletenessCurve, SpreadsErrorsEvenlyOverTies) {
  const CompletenessCurve first = Curve({true, false, false, false, true}, {0, 7, 7, 7, 7});
  const CompletenessCurve second = Curve({true, true, false, false, false}, {0, 7, 7, 7, 7});
  const double area = 100 * (1 + 1.25 / 2 + 1.5 / 3 + 1.75 / 4 + 2.0 / 5) / 5;
  EXPECT_DOUBLE_EQ(first.Area(), area);
  EXPECT_DOUBLE_EQ(second.Area(), area);
  EXPECT_DOUBLE_EQ(first.ErrorAt(0.6), 100 * 1.5 / 3);
}

TEST(CompletenessCurve, IsFlatWithoutInformation) {
  const CompletenessCurve curve = Curve({true, false, false, false}, {2, 2, 2, 2});
  EXPECT_DOUBLE_EQ(curve.ErrorAt(0.5), 25);
  EXPECT_DOUBLE_EQ(curve.Area(), 25);
}

TEST(CompletenessCurve, CountsNanAsMostUncertain) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const CompletenessCurve curve = Curve({true, false, true}, {nan, 1, nan});
  EXPECT_DOUBLE_EQ(curve.ErrorAt(0.3), 0);
  EXPECT_DOUBLE_EQ(curve.ErrorAt(1.0), 100.0 * 2 / 3);
}

TEST(CompletenessCurve, LeavesOutPixelsThatAreNotEvaluated) {
  const cv::Mat bad = (cv::Mat_<std::uint8_t>(1, 3) << 255, 0, 0);
  const cv::Mat evaluated = (cv::Mat_<std::uint8_t>(1, 3) << 0, 255, 255);
  const cv::Mat uncertainty = (cv::Mat_<float>(1, 3) << 0, 1, 2);
  EXPECT_DOUBLE_EQ(CompletenessCurve(bad, evaluated, uncertainty).Area(), 0);
  const CompletenessCurve none(bad, cv::Mat::zeros(1, 3, CV_8U), uncertainty);
  EXPECT_TRUE(std::isnan(none.Area()));
  EXPECT_TRUE(std::isnan(none.ErrorAt(0.5)));
}

}  // namespace
}  // namespace stereo_sgmp
