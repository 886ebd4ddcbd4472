#include "prior/plane_set_prior.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "prior/unpack_jumps.h"

namespace stereo_sgmp {
namespace {

constexpr PathStep kSteps[] = {{1, 0}, {-1, 0},  {0, 1},  {0, -1},
                               {1, 1}, {-1, -1}, {1, -1}, {-1, 1}};

struct Scene {
  VolumeShape shape;
  std::vector<DisparityPlane> planes;
  PlaneSets sets;
};

VolumeShape Shape(int width, int height, int disparities, int min_disparity) {
  VolumeShape shape;
  shape.width = width;
  shape.height = height;
  shape.disparities = disparities;
  shape.min_disparity = min_disparity;
  return shape;
}

// Coefficients are whole numbers of 2^-16, so that doubles hold every value exactly.
double Coefficient(std::mt19937* random, double limit) {
  std::uniform_real_distribution<double> value(-limit, limit);
  return std::round(value(*random) * 65536.0) / 65536.0;
}

Scene RandomScene(const VolumeShape& shape, cv::Size coarse, int planes, int max_in_set,
                  double slope, unsigned seed) {
  std::mt19937 random(seed);
  Scene scene;
  scene.shape = shape;
  for (int i = 0; i < planes; ++i) {
    const double middle = shape.min_disparity + shape.disparities / 2.0;
    const double most = i % 3 == 1 ? 0.0 : slope;  // every third plane is constant
    scene.planes.push_back({Coefficient(&random, most), Coefficient(&random, most),
                            middle + Coefficient(&random, 0.7 * shape.disparities)});
  }
  scene.sets.sets.emplace_back();
  for (int i = 0; i < 12; ++i) {
    PlaneSet set;
    set.count = static_cast<std::uint8_t>(
        1 + static_cast<int>(random() % static_cast<unsigned>(max_in_set)));
    for (std::size_t k = 0; k < set.count; ++k) {
      set.planes[k] = static_cast<std::int16_t>(random() % static_cast<unsigned>(planes));
    }
    scene.sets.sets.push_back(set);
  }
  scene.sets.ids.create(coarse, CV_16UC1);
  for (int y = 0; y < coarse.height; ++y) {
    for (int x = 0; x < coarse.width; ++x) {
      scene.sets.ids.at<std::uint16_t>(y, x) =
          static_cast<std::uint16_t>(random() % scene.sets.sets.size());
    }
  }
  return scene;
}

const PlaneSet& SetAt(const Scene& scene, int x, int y) {
  const cv::Mat& ids = scene.sets.ids;
  const int column = static_cast<int>((x + 0.5) * ids.cols / scene.shape.width);
  const int row = static_cast<int>((y + 0.5) * ids.rows / scene.shape.height);
  return scene.sets.sets[ids.at<std::uint16_t>(row, column)];
}

int RoundedIndex(const Scene& scene, int plane, int x, int y) {
  const double value = scene.planes[static_cast<std::size_t>(plane)].At(x, y);
  return static_cast<int>(std::floor(value + 0.5)) - scene.shape.min_disparity;
}

// The paper's way: render the surfaces into the column of the pixel, carry them upwards in a
// forward scan and downwards in a backward scan. The plane for each disparity index; empty
// where the pixel has none. The column is extended so that it holds surfaces out of range too.
std::vector<int> ScanColumn(const Scene& scene, int x, int y) {
  constexpr int kMargin = 4096;
  const PlaneSet& set = SetAt(scene, x, y);
  if (set.count == 0) return {};
  const int size = scene.shape.disparities + 2 * kMargin;
  std::vector<int> plane(static_cast<std::size_t>(size), -1);
  std::vector<int> distance(plane.size(), std::numeric_limits<int>::max() / 2);
  for (int k = set.count - 1; k >= 0; --k) {
    const int rendered = set.planes[static_cast<std::size_t>(k)];
    const auto at = static_cast<std::size_t>(RoundedIndex(scene, rendered, x, y) + kMargin);
    plane[at] = rendered;
    distance[at] = 0;
  }
  for (std::size_t d = 1; d < plane.size(); ++d) {
    if (distance[d - 1] + 1 < distance[d]) {
      std::tie(plane[d], distance[d]) = std::make_pair(plane[d - 1], distance[d - 1] + 1);
    }
  }
  for (std::size_t d = plane.size() - 1; d-- > 0;) {
    if (distance[d + 1] + 1 < distance[d]) {
      std::tie(plane[d], distance[d]) = std::make_pair(plane[d + 1], distance[d + 1] + 1);
    }
  }
  return {plane.begin() + kMargin, plane.begin() + kMargin + scene.shape.disparities};
}

// The scanned columns of all pixels, for all steps and targets.
class ScannedScene {
 public:
  explicit ScannedScene(const Scene& scene) : scene_(scene) {
    for (int y = 0; y < scene.shape.height; ++y) {
      for (int x = 0; x < scene.shape.width; ++x) columns_.push_back(ScanColumn(scene, x, y));
    }
  }

  std::vector<int> ExpectedJumps(JumpPolicy policy, int x, int y, PathStep step) const {
    const int disparities = scene_.shape.disparities;
    std::vector<int> jumps(static_cast<std::size_t>(disparities), 0);
    const int px = x - step.dx;
    const int py = y - step.dy;
    if (px < 0 || py < 0 || px >= scene_.shape.width || py >= scene_.shape.height) return jumps;
    const std::vector<int>& at_p = Column(px, py);
    const std::vector<int>& at_q = policy == JumpPolicy::kLiteral ? Column(x, y) : at_p;
    if (at_p.empty() || at_q.empty()) return jumps;
    for (std::size_t d = 0; d < jumps.size(); ++d) {
      const int jump = RoundedIndex(scene_, at_q[d], x, y) - RoundedIndex(scene_, at_p[d], px, py);
      jumps[d] = std::max(-disparities, std::min(disparities, jump));
    }
    return jumps;
  }

 private:
  const std::vector<int>& Column(int x, int y) const {
    return columns_[static_cast<std::size_t>(y * scene_.shape.width + x)];
  }

  const Scene& scene_;
  std::vector<std::vector<int>> columns_;
};

// Asks for `span` pixels at a time.
void ExpectEqualsScan(const Scene& scene, const ScannedScene& scanned, JumpPolicy policy,
                      int span) {
  PlaneSetPrior prior;
  prior.Assign(scene.planes, scene.sets, scene.shape, policy);
  JumpRow row;
  for (const PathStep step : kSteps) {
    for (int y = 0; y < scene.shape.height; ++y) {
      for (int begin = 0; begin < scene.shape.width; begin += span) {
        const int end = std::min(scene.shape.width, begin + span);
        prior.Jumps(y, begin, end, step, &row);
        for (int x = begin; x < end; ++x) {
          ASSERT_EQ(Unpack(row, static_cast<std::size_t>(x - begin), scene.shape.disparities),
                    scanned.ExpectedJumps(policy, x, y, step))
              << "x " << x << " y " << y << " step " << step.dx << " " << step.dy;
        }
      }
    }
  }
}

// Steps that are asked for together are those that are asked for one by one.
void ExpectTogetherAsAlone(const Scene& scene, JumpPolicy policy, int span) {
  const std::vector<std::vector<PathStep>> groups = {
      {{1, 0}}, {{0, 1}, {1, 1}, {-1, 1}}, {{0, -1}, {-1, -1}}, {{1, 1}, {0, 1}, {1, 1}, {-1, 1}}};
  PlaneSetPrior prior;
  prior.Assign(scene.planes, scene.sets, scene.shape, policy);
  std::vector<JumpRow> together(4);
  JumpRow alone;
  for (const std::vector<PathStep>& steps : groups) {
    for (int y = 0; y < scene.shape.height; ++y) {
      for (int begin = 0; begin < scene.shape.width; begin += span) {
        const int end = std::min(scene.shape.width, begin + span);
        prior.JumpsOfSteps(y, begin, end, steps.data(), static_cast<int>(steps.size()),
                           together.data());
        for (std::size_t s = 0; s < steps.size(); ++s) {
          prior.Jumps(y, begin, end, steps[s], &alone);
          for (int x = begin; x < end; ++x) {
            const auto entry = static_cast<std::size_t>(x - begin);
            ASSERT_EQ(Unpack(together[s], entry, scene.shape.disparities),
                      Unpack(alone, entry, scene.shape.disparities))
                << "x " << x << " y " << y << " step " << steps[s].dx << " " << steps[s].dy;
          }
        }
      }
    }
  }
}

struct Case {
  int width, height, disparities, min_disparity;
  cv::Size coarse;
  int planes, max_in_set;
  double slope = 1.2;  // up to it, in x and y
};

class PlaneSetPriorScan : public testing::TestWithParam<Case> {};

TEST_P(PlaneSetPriorScan, EqualsForwardAndBackwardScan) {
  const Case& c = GetParam();
  const Scene scene = RandomScene(Shape(c.width, c.height, c.disparities, c.min_disparity),
                                  c.coarse, c.planes, c.max_in_set, c.slope, 7);
  const ScannedScene scanned(scene);
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    ExpectEqualsScan(scene, scanned, JumpPolicy::kSameSurface, 37);
    ExpectEqualsScan(scene, scanned, JumpPolicy::kSameSurface, 200);
    ExpectEqualsScan(scene, scanned, JumpPolicy::kLiteral, 37);
    ExpectTogetherAsAlone(scene, JumpPolicy::kSameSurface, 48);
    ExpectTogetherAsAlone(scene, JumpPolicy::kLiteral, 48);
  }
  hwy::SetSupportedTargetsForTest(0);
}

INSTANTIATE_TEST_SUITE_P(
    Sizes, PlaneSetPriorScan,
    testing::Values(Case{41, 13, 32, 0, {11, 4}, 5, 1}, Case{41, 13, 32, 0, {10, 3}, 6, 3},
                    Case{75, 5, 70, -20, {19, 2}, 9, 8}, Case{140, 4, 40, 0, {3, 2}, 9, 5, 0.1},
                    Case{150, 3, 33, -4, {2, 1}, 5, 4, 0.02}, Case{9, 7, 16, 5, {9, 7}, 4, 4},
                    Case{3, 2, 8, 0, {5, 4}, 3, 2}, Case{1, 1, 4, 0, {1, 1}, 2, 2},
                    Case{1, 9, 4, 0, {1, 3}, 2, 2}, Case{9, 1, 4, 0, {3, 1}, 2, 2}));

// Each plane with a copy below and one above it, in the order in which they attract.
Scene WithCopies(const Scene& scene, double below, double above) {
  Scene copied = scene;
  copied.planes.clear();
  for (const DisparityPlane& plane : scene.planes) {
    copied.planes.push_back(plane);
    copied.planes.push_back({plane.a, plane.b, plane.c - below});
    copied.planes.push_back({plane.a, plane.b, plane.c + above});
  }
  for (PlaneSet& set : copied.sets.sets) {
    if (set.count == 0) continue;
    const auto plane = static_cast<std::int16_t>(3 * set.planes[0]);
    const auto next = [plane](int i) { return static_cast<std::int16_t>(plane + i); };
    set = {3, {plane, next(1), next(2)}};
  }
  return copied;
}

// Half a disparity is the most that is followed as a plane with phases; slopes are from gentle ones
// to some at which both cells jump, and planes leave the range at either end.
TEST(PlaneSetPrior, PlanesWithCopiesEqualTheScan) {
  const std::pair<double, double> distances[] = {
      {0.25, 0.25}, {0.5, 0.5}, {0.375, 0.0}, {0.5, 0.75}};
  for (const double slope : {0.05, 0.3, 4.0}) {
    const Scene scene = RandomScene(Shape(50, 3, 7, -3), {9, 2}, 24, 1, slope, 3);
    for (const auto& [below, above] : distances) {
      SCOPED_TRACE(testing::Message() << slope << ", " << below << " below, " << above << " above");
      const Scene copied = WithCopies(scene, below, above);
      const ScannedScene scanned(copied);
      for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        SCOPED_TRACE(hwy::TargetName(target));
        hwy::SetSupportedTargetsForTest(target);
        ExpectEqualsScan(copied, scanned, JumpPolicy::kSameSurface, 37);
        ExpectTogetherAsAlone(copied, JumpPolicy::kSameSurface, 48);
      }
    }
  }
  hwy::SetSupportedTargetsForTest(0);
}

Scene OnePlane(const DisparityPlane& plane) {
  Scene scene;
  scene.shape = Shape(130, 6, 64, 0);
  scene.planes = {plane};
  scene.sets.sets.resize(2);
  scene.sets.sets[1].count = 1;
  scene.sets.ids = cv::Mat(3, 33, CV_16UC1, cv::Scalar(1));
  return scene;
}

std::vector<std::int16_t> JumpsOf(const Scene& scene, int y, PathStep step) {
  PlaneSetPrior prior;
  prior.Assign(scene.planes, scene.sets, scene.shape, JumpPolicy::kSameSurface);
  JumpRow row;
  prior.Jumps(y, 0, scene.shape.width, step, &row);
  return Values(row.jump);
}

TEST(PlaneSetPrior, SurfaceOfTwoEqualPlanesIsThatOfOne) {
  const Scene one = OnePlane({0.3, -0.2, 12.4});
  Scene twice = one;
  twice.planes.push_back(one.planes[0]);
  twice.sets.sets[1] = {2, {0, 1}};
  EXPECT_EQ(JumpsOf(one, 3, {1, 1}), JumpsOf(twice, 3, {1, 1}));
}

TEST(PlaneSetPrior, WholeNumberAddedToPlaneChangesNothing) {
  const Scene scene = OnePlane({0.31415926, -0.2718281, 12.4});
  Scene moved = scene;
  moved.planes[0].c += 23.0;
  for (const PathStep step : kSteps) EXPECT_EQ(JumpsOf(scene, 2, step), JumpsOf(moved, 2, step));
}

TEST(PlaneSetPrior, OppositeDirectionFlipsSign) {
  const Scene scene = OnePlane({0.4, 0.1, 3.0});
  const auto there = JumpsOf(scene, 2, {1, 1});
  const auto back = JumpsOf(scene, 1, {-1, -1});
  for (std::size_t x = 1; x < there.size(); ++x) EXPECT_EQ(there[x], -back[x - 1]);
}

TEST(PlaneSetPrior, PoliciesDifferAtLabelBorderOnly) {
  Scene scene = OnePlane({0.0, 0.0, 10.0});
  scene.planes.push_back({0.0, 0.0, 30.0});
  scene.sets.sets.push_back({1, {1}});
  scene.sets.ids.colRange(16, 33).setTo(2);
  PlaneSetPrior prior;
  JumpRow row;
  prior.Assign(scene.planes, scene.sets, scene.shape, JumpPolicy::kSameSurface);
  prior.Jumps(0, 0, 130, {1, 0}, &row);
  EXPECT_EQ(Values(row.jump), std::vector<std::int16_t>(130, 0));
  prior.Assign(scene.planes, scene.sets, scene.shape, JumpPolicy::kLiteral);
  prior.Jumps(0, 0, 130, {1, 0}, &row);
  const std::vector<std::int16_t> jumps = Values(row.jump);
  EXPECT_EQ(std::count(jumps.begin(), jumps.end(), 20), 1);
  EXPECT_EQ(std::count(jumps.begin(), jumps.end(), 0), 129);
}

TEST(PlaneSetPrior, LimitsSteepJumps) {
  const Scene scene = OnePlane({500.0, 0.0, 0.0});
  const auto jumps = JumpsOf(scene, 0, {1, 0});
  EXPECT_EQ(jumps[5], 64);
}

TEST(PlaneSetPrior, RefusesPlanesThatAreNotFinite) {
  Scene scene = OnePlane({std::nan(""), 0.0, 0.0});
  PlaneSetPrior prior;
  EXPECT_THROW(prior.Assign(scene.planes, scene.sets, scene.shape, JumpPolicy::kLiteral),
               std::invalid_argument);
}

}  // namespace
}  // namespace stereo_sgmp
