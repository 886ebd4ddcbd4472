#include "prior/manhattan/constrained_planes.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

// Votes of a plane whose n.(u, v, f) grows from `facing` on.
void AddPlane(double rho, int count, double facing, std::vector<PlaneVote>* votes) {
  for (int i = 0; i < count; ++i) {
    const double g = facing * (1.0 + 0.01 * i);
    votes->push_back({g, rho * g});
  }
}

TEST(ConstrainedPlanes, FitHasTheLeastSquaredError) {
  // Minimises (10 - 100 rho)^2 + (22 - 200 rho)^2.
  const ConstrainedPlane plane = FitConstrainedPlane({{100.0, 10.0}, {200.0, 22.0}});
  EXPECT_DOUBLE_EQ(plane.rho, 5400.0 / 50000.0);
  EXPECT_EQ(plane.support, 2);
  EXPECT_NEAR(plane.rms, std::sqrt((0.8 * 0.8 + 0.4 * 0.4) / 2.0), 1e-12);
}

TEST(ConstrainedPlanes, FitWithoutVotes) {
  EXPECT_EQ(FitConstrainedPlane({}).support, 0);
  EXPECT_EQ(FitConstrainedPlane({}).rho, 0.0);
}

TEST(ConstrainedPlanes, FindsEachPlaneExactly) {
  std::vector<PlaneVote> votes;
  AddPlane(0.05, 60, -400.0, &votes);  // d' < 0: these can't be
  AddPlane(0.05, 50, 400.0, &votes);
  AddPlane(0.12, 80, 400.0, &votes);
  const auto planes = FindConstrainedPlanes(votes, 0.75, 30);
  ASSERT_EQ(planes.size(), 2U);
  EXPECT_NEAR(planes[0].rho, 0.12, 1e-12);
  EXPECT_EQ(planes[0].support, 80);
  EXPECT_NEAR(planes[1].rho, 0.05, 1e-12);
  EXPECT_EQ(planes[1].support, 50);
  EXPECT_NEAR(planes[1].rms, 0.0, 1e-9);
}

TEST(ConstrainedPlanes, NormalsMayPointEitherWay) {
  std::vector<PlaneVote> votes;
  AddPlane(-0.05, 60, -400.0, &votes);
  const auto planes = FindConstrainedPlanes(votes, 0.75, 30);
  ASSERT_EQ(planes.size(), 1U);
  EXPECT_NEAR(planes[0].rho, -0.05, 1e-12);
}

TEST(ConstrainedPlanes, VotesWithinTheToleranceSupportOnePlane) {
  std::vector<PlaneVote> votes;
  for (int i = 0; i < 40; ++i) votes.push_back({500.0, i % 2 == 0 ? 20.5 : 19.5});
  EXPECT_EQ(FindConstrainedPlanes(votes, 0.75, 30).size(), 1U);
  EXPECT_EQ(FindConstrainedPlanes(votes, 0.25, 30).size(), 0U) << "two planes of 20 votes";
  EXPECT_EQ(FindConstrainedPlanes(votes, 0.25, 20).size(), 2U);
}

TEST(ConstrainedPlanes, NeedsTheSupportAsked) {
  std::vector<PlaneVote> votes;
  AddPlane(0.05, 30, 400.0, &votes);
  EXPECT_EQ(FindConstrainedPlanes(votes, 0.75, 30).size(), 1U);
  EXPECT_TRUE(FindConstrainedPlanes(votes, 0.75, 31).empty());
}

TEST(ConstrainedPlanes, AtMostFour) {
  std::vector<PlaneVote> votes;
  for (int i = 1; i <= 6; ++i) AddPlane(0.03 * i, 40 + i, 400.0, &votes);
  const auto planes = FindConstrainedPlanes(votes, 0.75, 30);
  ASSERT_EQ(planes.size(), 4U);
  EXPECT_EQ(planes[3].support, 43);
}

TEST(ConstrainedPlanes, VotesThatCantBeAreLeftOut) {
  std::vector<PlaneVote> votes;
  AddPlane(0.05, 40, 400.0, &votes);
  votes.push_back({400.0, std::numeric_limits<double>::quiet_NaN()});
  votes.push_back({400.0, std::numeric_limits<double>::infinity()});
  votes.push_back({0.0, 20.0});
  const auto planes = FindConstrainedPlanes(votes, 0.75, 30);
  ASSERT_EQ(planes.size(), 1U);
  EXPECT_EQ(planes[0].support, 40);
}

}  // namespace
}  // namespace stereo_sgmp
