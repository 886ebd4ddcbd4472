#include "ros/rig_watch.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "matcher/repeating_pair.h"
#include "stereo_sgmp/matcher.h"

namespace stereo_sgmp {
namespace {

const cv::Size kSize(480, 360);

Options FewDisparities() {
  Options options;
  options.num_disparities = 64;
  return options;
}

MatchStatistics StatisticsOf(const cv::Mat& left, const cv::Mat& right) {
  MatchResult result;
  Matcher(FewDisparities()).Match(left, right, &result);
  return result.statistics;
}

std::vector<std::string> ProblemsOf(const cv::Mat& left, const cv::Mat& right) {
  std::vector<std::string> kinds;
  for (const RigProblem& problem :
       RigWatch().Check(left, right, FewDisparities(), StatisticsOf(left, right))) {
    kinds.push_back(problem.kind);
  }
  return kinds;
}

// Many pixels of such an exchanged pair match by chance.
TEST(RigWatch, SeesThatCamerasAreExchangedWhereTextureRepeats) {
  for (const double period : {14.0, 40.0}) {
    SCOPED_TRACE(period);
    const RepeatingPair pair = MakeRepeatingPair(kSize, period, 10.0);
    EXPECT_EQ(ProblemsOf(pair.left, pair.right), std::vector<std::string>());
    EXPECT_EQ(ProblemsOf(pair.right, pair.left), std::vector<std::string>{"swapped"})
        << StatisticsOf(pair.right, pair.left).density;
  }
}

// The check is dear: it waits for a while after it has found nothing.
TEST(RigWatch, LooksAtTheOrderOfTheCamerasNowAndThen) {
  const RepeatingPair pair = MakeRepeatingPair(kSize, 20.0, 20.0);
  MatchStatistics sparse = StatisticsOf(pair.right, pair.left);
  sparse.density = 0.1;
  RigWatch watch;
  EXPECT_TRUE(watch.Check(pair.left, pair.right, FewDisparities(), sparse).empty());
  int frames = 1;
  while (watch.Check(pair.right, pair.left, FewDisparities(), sparse).empty() && frames < 100) {
    ++frames;
  }
  EXPECT_EQ(frames, 30);
}

TEST(RigWatch, ForgetsWhenTheCamerasAreInOrder) {
  const RepeatingPair pair = MakeRepeatingPair(kSize, 20.0, 20.0);
  RigWatch watch;
  EXPECT_FALSE(
      watch.Check(pair.right, pair.left, FewDisparities(), StatisticsOf(pair.right, pair.left))
          .empty());
  EXPECT_TRUE(
      watch.Check(pair.left, pair.right, FewDisparities(), StatisticsOf(pair.left, pair.right))
          .empty());
}

}  // namespace
}  // namespace stereo_sgmp
