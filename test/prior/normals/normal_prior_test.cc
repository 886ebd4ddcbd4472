#include "prior/normals/normal_prior.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "prior/normals/normal_maps.h"
#include "prior/surface_prior.h"
#include "prior/unpack_jumps.h"

namespace stereo_sgmp {
namespace {

constexpr PathStep kSteps[] = {{1, 0}, {-1, 0},  {0, 1},  {0, -1},
                               {1, 1}, {-1, -1}, {1, -1}, {-1, 1}};

VolumeShape Shape(int width, int height, int disparities, int min_disparity) {
  VolumeShape shape;
  shape.width = width;
  shape.height = height;
  shape.disparities = disparities;
  shape.min_disparity = min_disparity;
  return shape;
}

// Rough shapes in components of a few columns each, some of them unknown.
SurfaceFamily RandomFamily(const VolumeShape& shape, std::vector<float> scales, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> log_shape(-0.15F, 0.15F);
  SurfaceFamily family;
  family.scales = std::move(scales);
  family.doffs = 3.25F;
  family.shape.create(shape.height, shape.width);
  family.component.create(shape.height, shape.width);
  for (int y = 0; y < shape.height; ++y) {
    for (int x = 0; x < shape.width; ++x) {
      const float slant = 0.02F * static_cast<float>(x % 40) - 0.03F * static_cast<float>(y % 7);
      family.shape(y, x) = std::exp(slant + log_shape(random));
      family.component(y, x) = random() % 12 == 0 ? 0 : 1 + x / 23;
    }
  }
  return family;
}

int RoundedIndex(const SurfaceFamily& family, const VolumeShape& shape, std::size_t k, int y,
                 int x) {
  const float value = family.At(family.scales[k], family.shape(y, x));
  return static_cast<int>(std::floor(value + 0.5F)) - shape.min_disparity;
}

// The paper's way: render the surfaces into the column of the pixel, carry them upwards in a
// forward scan and downwards in a backward scan; the surface of each disparity index. The column
// is extended so that it holds surfaces out of range, too.
std::vector<std::size_t> ScanColumn(const SurfaceFamily& family, const VolumeShape& shape, int y,
                                    int x) {
  constexpr int kMargin = 2048;
  const auto size = static_cast<std::size_t>(shape.disparities + 2 * kMargin);
  std::vector<std::size_t> surface(size, 0);
  std::vector<int> distance(size, std::numeric_limits<int>::max() / 2);
  for (std::size_t k = family.scales.size(); k-- > 0;) {
    // Far out a surface stands at the end: only the order of distances counts.
    const auto at = static_cast<std::size_t>(
        std::clamp(RoundedIndex(family, shape, k, y, x) + kMargin, 0, static_cast<int>(size) - 1));
    surface[at] = k;
    distance[at] = 0;
  }
  const auto carry = [&](std::size_t from, std::size_t to) {
    if (distance[from] + 1 >= distance[to]) return;
    surface[to] = surface[from];
    distance[to] = distance[from] + 1;
  };
  for (std::size_t d = 1; d < size; ++d) carry(d - 1, d);
  for (std::size_t d = size - 1; d-- > 0;) carry(d + 1, d);
  return {surface.begin() + kMargin, surface.begin() + kMargin + shape.disparities};
}

std::vector<int> ExpectedJumps(const SurfaceFamily& family, const VolumeShape& shape, int y, int x,
                               PathStep step) {
  std::vector<int> jumps(static_cast<std::size_t>(shape.disparities), 0);
  const int px = x - step.dx;
  const int py = y - step.dy;
  if (px < 0 || py < 0 || px >= shape.width || py >= shape.height) return jumps;
  const int component = family.component(py, px);
  if (component == 0 || component != family.component(y, x)) return jumps;
  const std::vector<std::size_t> surface = ScanColumn(family, shape, py, px);
  for (std::size_t d = 0; d < jumps.size(); ++d) {
    const std::size_t k = surface[d];
    const int jump = RoundedIndex(family, shape, k, y, x) - RoundedIndex(family, shape, k, py, px);
    jumps[d] = std::clamp(jump, -shape.disparities, shape.disparities);
  }
  return jumps;
}

struct Case {
  int width, height, disparities, min_disparity;
  std::vector<float> scales;
};

class NormalPriorScan : public testing::TestWithParam<Case> {};

TEST_P(NormalPriorScan, EqualsForwardAndBackwardScan) {
  const Case& c = GetParam();
  const VolumeShape shape = Shape(c.width, c.height, c.disparities, c.min_disparity);
  const SurfaceFamily family = RandomFamily(shape, c.scales, 5);
  NormalPrior prior;
  prior.Assign(family, cv::Mat(), shape);
  JumpRow row;
  for (const PathStep step : kSteps) {
    for (int y = 0; y < shape.height; ++y) {
      for (int begin = 0; begin < shape.width; begin += 77) {
        const int end = std::min(shape.width, begin + 77);
        prior.Jumps(y, begin, end, step, &row);
        for (int x = begin; x < end; ++x) {
          ASSERT_EQ(Unpack(row, static_cast<std::size_t>(x - begin), shape.disparities),
                    ExpectedJumps(family, shape, y, x, step))
              << "x " << x << " y " << y << " step " << step.dx << " " << step.dy;
        }
      }
    }
  }
}

// Among them families that end within the range, that reach far beyond it, and of surfaces so
// close that several round to one disparity.
INSTANTIATE_TEST_SUITE_P(
    Sizes, NormalPriorScan,
    testing::Values(Case{83, 9, 64, 0, {4, 12, 20, 28, 36, 44, 53, 64, 77}},
                    Case{83, 9, 64, 0, {30, 33, 60}}, Case{41, 7, 32, 0, {0.2F, 0.5F, 9, 9.5F, 10}},
                    Case{150, 4, 70, -20, {0.1F, 1, 2, 3, 4, 9, 30, 100, 300, 301, 900}},
                    Case{150, 4, 40, 25, {5, 13, 21, 30, 40, 52, 66, 83}}, Case{9, 5, 16, 5, {12}},
                    Case{3, 2, 8, 0, {4, 8}}, Case{1, 1, 4, 0, {3, 6}}, Case{1, 9, 4, 0, {3, 6}},
                    Case{9, 1, 4, 0, {3, 6}}));

TEST(NormalPrior, FamilyOfOneSurfaceIsThatSurface) {
  const VolumeShape shape = Shape(90, 8, 48, -5);
  SurfaceFamily family = RandomFamily(shape, {30.0F}, 9);
  family.component.setTo(1);
  cv::Mat_<float> surface(family.shape.size());
  for (int y = 0; y < shape.height; ++y) {
    for (int x = 0; x < shape.width; ++x) surface(y, x) = family.At(30.0F, family.shape(y, x));
  }
  SurfacePrior expected;
  expected.Assign(surface, shape);
  NormalPrior prior;
  prior.Assign(family, cv::Mat(), shape);
  JumpRow row;
  JumpRow expected_row;
  for (const PathStep step : kSteps) {
    prior.Jumps(3, 0, shape.width, step, &row);
    expected.Jumps(3, 0, shape.width, step, &expected_row);
    EXPECT_EQ(Values(row.jump), Values(expected_row.jump));
    EXPECT_TRUE(row.segments.empty());
  }
}

// Two components in one cell meet between the columns 4 and 5, two cells between 9 and 10.
TEST(NormalPrior, PlacedSurfaceLeadsFromComponentToComponentOfACell) {
  const VolumeShape shape = Shape(14, 3, 64, 0);
  SurfaceFamily family;
  family.scales = {20.0F, 40.0F};
  family.shape = cv::Mat_<float>::ones(3, 14);
  family.component = cv::Mat_<int>(3, 14, 1);
  family.component.colRange(5, 10).setTo(2);
  family.component.colRange(10, 14).setTo(1 + IntegratedNormals::kCellArea);
  cv::Mat_<float> placed(3, 14, 12.0F);
  placed.colRange(5, 10).setTo(45.0F);
  JumpRow row;
  NormalPrior prior;
  prior.Assign(family, placed, shape);
  prior.Jumps(1, 2, 14, {1, 0}, &row);
  EXPECT_EQ(Values(row.jump), std::vector<std::int16_t>({0, 0, 0, 33, 0, 0, 0, 0, 0, 0, 0, 0}));
  prior.Jumps(1, 0, 14, {-1, -1}, &row);
  EXPECT_EQ(Values(row.jump),
            std::vector<std::int16_t>({0, 0, 0, 0, -33, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
  placed(1, 5) = std::numeric_limits<float>::quiet_NaN();
  prior.Assign(family, placed, shape);
  prior.Jumps(1, 0, 14, {1, 0}, &row);
  EXPECT_EQ(Values(row.jump), std::vector<std::int16_t>(14, 0));
  prior.Assign(family, cv::Mat(), shape);
  prior.Jumps(2, 0, 14, {1, 0}, &row);
  EXPECT_EQ(Values(row.jump), std::vector<std::int16_t>(14, 0));
}

TEST(NormalPrior, RefusesOtherSize) {
  NormalPrior prior;
  EXPECT_THROW(
      prior.Assign(RandomFamily(Shape(9, 5, 8, 0), {4.0F}, 1), cv::Mat(), Shape(9, 6, 8, 0)),
      std::invalid_argument);
}

class NormalPriorBuilderTest : public testing::Test {
 protected:
  // Where a path along the middle row ends that starts at x = 0 with disparity `d` and follows the
  // prior's jumps up to x = 59.
  double FollowRow(const NormalPriorSettings& settings, int d) {
    const OrientationPrior* prior = builder_.Build(settings, surface_.normals, cv::Mat(), camera_,
                                                   Coarse(), image_, shape_, &pool_);
    JumpRow row;
    prior->Jumps(20, 0, shape_.width, {1, 0}, &row);
    for (std::size_t x = 1; x < 60; ++x) {
      d += Unpack(row, x, shape_.disparities)[static_cast<std::size_t>(d)];
    }
    return d;
  }

  // Half the size, true and confident.
  CoarseDisparity Coarse() {
    cv::Mat half;
    cv::resize(surface_.disparity, half, {30, 20}, 0.0, 0.0, cv::INTER_NEAREST);
    half.convertTo(coarse_, CV_32F, 0.5);
    return {coarse_, confident_};
  }

  StereoCamera camera_ = OffCenterCamera();
  cv::Mat coarse_;
  cv::Mat confident_{20, 30, CV_8U, cv::Scalar(255)};
  cv::Mat image_{40, 60, CV_8U, cv::Scalar(90)};
  VolumeShape shape_ = Shape(60, 40, 128, 0);
  KnownSurface surface_ = PlaneSurface({60, 40}, {0.4, 0.1, 30.0}, camera_);
  ThreadPool pool_{2};
  NormalPriorBuilder builder_;
};

// A plane moved in depth scales d + doffs, and so its slant.
TEST_F(NormalPriorBuilderTest, SlantOfGnvGrowsWithDisparity) {
  const double at_start = surface_.disparity(20, 0) + camera_.doffs;
  const double at_end = surface_.disparity(20, 59) + camera_.doffs;
  for (const int start : {5, 30, 60, 80}) {
    const double end = (start + camera_.doffs) * at_end / at_start - camera_.doffs;
    EXPECT_NEAR(FollowRow({}, start), end, 0.16 * (end - start)) << start;
  }
}

// The bar lies 50 disparities before the wall. Without a way across its edges the path would miss
// the wall behind it by what that rises there.
TEST_F(NormalPriorBuilderTest, GnvLeadsFromWallToBarAndBack) {
  surface_.Draw({20, 0, 16, 40}, {0.0, 0.0, 90.0}, camera_);
  ASSERT_GT(cv::norm(surface_.normals(20, 10), surface_.normals(20, 25)), 0.3);
  const int start = static_cast<int>(std::lround(surface_.disparity(20, 0)));
  EXPECT_NEAR(FollowRow({}, start), surface_.disparity(20, 59), 3.5);
}

// The normals of bar and wall are the same.
TEST_F(NormalPriorBuilderTest, GnvStepsAtAnEdgeOfTheImageBetweenParallelSurfaces) {
  surface_ = PlaneSurface({60, 40}, {0.0, 0.0, 30.0}, camera_);
  surface_.Draw({19, 0, 41, 40}, {0.0, 0.0, 90.0}, camera_);
  image_.colRange(19, 60).setTo(150);
  EXPECT_EQ(FollowRow({}, 30), 90.0);
}

TEST_F(NormalPriorBuilderTest, SlantOfGniIsThatOfItsDepth) {
  NormalPriorSettings settings;
  settings.all_depths = false;
  settings.disparity = cv::mean(surface_.disparity)[0];
  for (const int start : {5, 30, 60, 80}) {
    EXPECT_NEAR(FollowRow(settings, start), start + 0.4 * 59, 1.5) << start;
  }
}

TEST_F(NormalPriorBuilderTest, GniLiesInTheMiddleOfTheRangeUnlessToldOtherwise) {
  NormalPriorSettings settings;
  settings.all_depths = false;
  const double unset = FollowRow(settings, 30);
  settings.disparity = 63.5;
  EXPECT_EQ(FollowRow(settings, 30), unset);
  settings.disparity = 20.0;
  EXPECT_LT(FollowRow(settings, 30), unset);
}

TEST_F(NormalPriorBuilderTest, RefusesMalformedInput) {
  const auto build = [this](const cv::Mat& normals) {
    builder_.Build({}, normals, cv::Mat(), camera_, Coarse(), image_, shape_, &pool_);
  };
  EXPECT_THROW(build(cv::Mat()), std::invalid_argument);
  EXPECT_THROW(build(surface_.normals.rowRange(0, 39)), std::invalid_argument);
  EXPECT_THROW(build(cv::Mat(surface_.disparity)), std::invalid_argument);
  EXPECT_THROW(build(surface_.normals * 0.0), std::invalid_argument);
  EXPECT_NO_THROW(build(surface_.normals));
  camera_.doffs = -200.0;
  EXPECT_THROW(build(surface_.normals), std::invalid_argument);
  camera_.focal_length = 0.0;
  EXPECT_THROW(build(surface_.normals), std::invalid_argument);
}

}  // namespace
}  // namespace stereo_sgmp
