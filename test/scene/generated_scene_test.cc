#include "scene/generated_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace stereo_sgmp {
namespace {

constexpr SceneKind kAllKinds[] = {SceneKind::kCorridor, SceneKind::kSlantedPlane, SceneKind::kRoom,
                                   SceneKind::kFrontoParallel, SceneKind::kFence};
const cv::Size kSize(320, 200);
constexpr int kDisparities = 64;

// Without noise, blur and vignetting the two views differ by nothing but geometry.
SceneQuality Ideal() {
  SceneQuality quality;
  quality.noise = 0;
  quality.blur = 0;
  quality.vignetting = 0;
  return quality;
}

// |left(x, y) - right(x - d, row(y))| of the gray values, over the pixels with mask 255; the
// median, as a pixel at an edge shows a mixture of surfaces.
double MedianDifference(const GeneratedScene& scene, const std::function<double(double)>& row) {
  cv::Mat map(scene.left.size(), CV_32FC2);
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) {
      const float d = scene.disparity.at<float>(y, x);
      map.at<cv::Vec2f>(y, x) = {static_cast<float>(x) - d, static_cast<float>(row(y))};
    }
  }
  cv::Mat warped;
  cv::remap(scene.right, warped, map, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  cv::Mat difference;
  cv::absdiff(scene.left, warped, difference);
  std::vector<std::uint8_t> values;
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) {
      if (scene.mask.at<std::uint8_t>(y, x) == 255) {
        values.push_back(difference.at<cv::Vec3b>(y, x)[1]);
      }
    }
  }
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

TEST(GeneratedScene, RightImageShowsWhatTheDisparitySays) {
  for (const SceneKind kind : kAllKinds) {
    const GeneratedScene scene = MakeScene(kind, kSize, kDisparities, Ideal(), 3);
    EXPECT_LE(MedianDifference(scene, [](double y) { return y; }), 3) << static_cast<int>(kind);
    GeneratedScene wrong = scene;
    wrong.disparity += 3;
    if (kind == SceneKind::kCorridor || kind == SceneKind::kRoom) continue;  // hardly textured
    EXPECT_GT(MedianDifference(wrong, [](double y) { return y; }), 5) << static_cast<int>(kind);
  }
}

TEST(GeneratedScene, DisparitiesFillTheRange) {
  for (const SceneKind kind : kAllKinds) {
    const GeneratedScene scene = MakeScene(kind, kSize, kDisparities, Ideal(), 4);
    double min = 0;
    double max = 0;
    cv::minMaxLoc(scene.disparity, &min, &max);
    EXPECT_GT(min, 0);
    EXPECT_LT(max, kDisparities);
    EXPECT_GT(max, 0.6 * kDisparities);
    EXPECT_EQ(scene.left.type(), CV_8UC3);
    EXPECT_EQ(scene.left.size(), kSize);
    EXPECT_EQ(scene.right.size(), kSize);
  }
}

TEST(GeneratedScene, IsTheSameForTheSameSeedOnly) {
  const GeneratedScene a = MakeScene(SceneKind::kRoom, kSize, kDisparities, {}, 5);
  const GeneratedScene b = MakeScene(SceneKind::kRoom, kSize, kDisparities, {}, 5);
  const GeneratedScene c = MakeScene(SceneKind::kRoom, kSize, kDisparities, {}, 6);
  EXPECT_EQ(cv::norm(a.left, b.left, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(a.right, b.right, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(a.disparity, b.disparity, cv::NORM_INF), 0);
  EXPECT_GT(cv::norm(a.left, c.left, cv::NORM_INF), 0);
}

TEST(SlantedPlane, HasTheSlantsAskedFor) {
  constexpr double kSlantX = 0.11;
  constexpr double kSlantY = -0.07;
  const GeneratedScene scene = MakeSlantedPlane(kSize, kDisparities, kSlantX, kSlantY, Ideal(), 1);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const double expected = kDisparities / 2.0 + kSlantX * (x - (kSize.width - 1) / 2.0) +
                              kSlantY * (y - (kSize.height - 1) / 2.0);
      ASSERT_NEAR(scene.disparity.at<float>(y, x), expected, 1e-4) << x << ", " << y;
    }
  }
}

TEST(SlantedPlane, IsOccludedOnlyWhereTheRightImageEnds) {
  const GeneratedScene scene = MakeSlantedPlane(kSize, kDisparities, 0.05, 0.05, Ideal(), 1);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const float right_x = static_cast<float>(x) - scene.disparity.at<float>(y, x);
      if (std::abs(right_x) < 1e-3F) continue;  // on the border: rounding decides
      ASSERT_EQ(scene.mask.at<std::uint8_t>(y, x), right_x > 0 ? 255 : 128) << x << ", " << y;
    }
  }
}

// A pixel of the wall is hidden where a bar, which has a larger disparity, covers its place in
// the right image. The bars stand upright, so one row tells all.
TEST(Fence, OccludesTheWallBehindTheBars) {
  const GeneratedScene scene = MakeScene(SceneKind::kFence, kSize, kDisparities, Ideal(), 2);
  const int y = kSize.height / 2;
  const auto disparity = [&](int x) { return scene.disparity.at<float>(y, x); };
  const auto right_x = [&](int x) { return static_cast<float>(x) - disparity(x); };
  int hidden = 0;
  // Further right, bars that only the right camera sees may hide the wall.
  for (int x = 0; x < kSize.width - kDisparities; ++x) {
    const int mask = scene.mask.at<std::uint8_t>(y, x);
    if (right_x(x) < 0) {
      EXPECT_EQ(mask, 128) << x;
      continue;
    }
    float distance = static_cast<float>(kSize.width);  // to the nearest pixel of a bar, right view
    for (int bar = x + 1; bar < kSize.width; ++bar) {
      if (disparity(bar) < disparity(x) + 2) continue;
      distance = std::min(distance, std::abs(right_x(bar) - right_x(x)));
    }
    // Between the two its exact place decides.
    const bool surely_hidden = distance < 0.5F;
    const bool surely_seen = distance > 1.0F;
    if (surely_hidden || surely_seen) {
      EXPECT_EQ(mask, surely_hidden ? 128 : 255) << x;
    }
    if (surely_hidden) ++hidden;
  }
  EXPECT_GT(hidden, kSize.width / 20);
}

TEST(SceneQuality, ExposureChangesTheRightImageOnly) {
  SceneQuality quality = Ideal();
  const GeneratedScene plain = MakeScene(SceneKind::kRoom, kSize, kDisparities, quality, 7);
  quality.gain = 0.8;
  quality.offset = 12;
  const GeneratedScene dark = MakeScene(SceneKind::kRoom, kSize, kDisparities, quality, 7);
  EXPECT_EQ(cv::norm(plain.left, dark.left, cv::NORM_INF), 0);
  cv::Mat expected;
  plain.right.convertTo(expected, CV_8U, 0.8, 12);
  EXPECT_LE(cv::norm(expected, dark.right, cv::NORM_INF), 1);
}

TEST(SceneQuality, VerticalResidualMovesRowsOfTheRightImage) {
  SceneQuality quality = Ideal();
  quality.vertical_scale = 1.01;
  quality.vertical_offset = -3;
  const GeneratedScene scene = MakeScene(SceneKind::kSlantedPlane, kSize, kDisparities, quality, 8);
  EXPECT_LE(MedianDifference(scene, [](double y) { return 1.01 * y - 3; }), 3);
  EXPECT_GT(MedianDifference(scene, [](double y) { return y; }), 5);
}

TEST(SceneQuality, NoiseHasTheDeviationAskedFor) {
  SceneQuality quality = Ideal();
  const GeneratedScene clean = MakeScene(SceneKind::kRoom, kSize, kDisparities, quality, 9);
  quality.noise = 4;
  const GeneratedScene noisy = MakeScene(SceneKind::kRoom, kSize, kDisparities, quality, 9);
  cv::Mat difference;
  cv::subtract(noisy.left, clean.left, difference, cv::noArray(), CV_32F);
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(difference, mean, deviation);
  EXPECT_NEAR(mean[0], 0, 0.1);
  EXPECT_NEAR(deviation[0], 4, 0.2);
}

TEST(MakeScene, RefusesWhatItCannotMake) {
  EXPECT_THROW(MakeScene(SceneKind::kRoom, {320, 200}, 200, {}, 1), std::invalid_argument);
  EXPECT_THROW(MakeScene(SceneKind::kRoom, {320, 200}, 4, {}, 1), std::invalid_argument);
  EXPECT_THROW(MakeScene(SceneKind::kRoom, {0, 0}, 8, {}, 1), std::invalid_argument);
  EXPECT_THROW(MakeSlantedPlane(kSize, kDisparities, 1, 0, {}, 1), std::invalid_argument);
  EXPECT_THROW(SceneKindFromName("garden"), std::invalid_argument);
  EXPECT_EQ(SceneKindFromName("fence"), SceneKind::kFence);
}

}  // namespace
}  // namespace stereo_sgmp
