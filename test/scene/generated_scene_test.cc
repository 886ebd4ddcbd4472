#include "scene/generated_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

namespace stereo_sgmp {
namespace {

constexpr SceneKind kAllKinds[] = {SceneKind::kCorridor, SceneKind::kSlantedPlane,
                                   SceneKind::kRoom,     SceneKind::kFrontoParallel,
                                   SceneKind::kFence,    SceneKind::kCurved};
const cv::Size kSize(320, 200);
constexpr int kDisparities = 64;

// Without noise, blur and vignetting the two views differ by nothing but geometry.
SceneQuality Ideal() {
  SceneQuality quality;
  quality.noise = 0;
  quality.blur = 0;
  quality.vignetting = 0;
  quality.right_vignetting = 0;
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
    const bool textured = kind == SceneKind::kSlantedPlane || kind == SceneKind::kFrontoParallel;
    if (!textured) continue;
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

Eigen::Vector3d NormalAt(const GeneratedScene& scene, int x, int y) {
  const auto& n = scene.normals.at<cv::Vec3f>(y, x);
  return {n[0], n[1], n[2]};
}

TEST(GeneratedScene, PlanesGiveDisparitiesAndNormals) {
  for (const SceneKind kind : kAllKinds) {
    SCOPED_TRACE(static_cast<int>(kind));
    const GeneratedScene scene = MakeScene(kind, kSize, kDisparities, Ideal(), 11);
    ASSERT_EQ(scene.labels.type(), CV_16S);
    ASSERT_EQ(scene.normals.type(), CV_32FC3);
    std::vector<int> pixels(scene.planes.size(), 0);
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < kSize.width; ++x) {
        const int label = scene.labels.at<std::int16_t>(y, x);
        if (label < 0) continue;
        ASSERT_LT(label, static_cast<int>(scene.planes.size()));
        const DisparityPlane& plane = scene.planes[static_cast<std::size_t>(label)];
        ASSERT_NEAR(plane.At(x, y), scene.disparity.at<float>(y, x), 1e-4);
        const Eigen::Vector3d expected = scene.camera.ToSpace(plane).normal;
        ASSERT_LT((NormalAt(scene, x, y) - expected).norm(), 1e-6) << x << ", " << y;
        ++pixels[static_cast<std::size_t>(label)];
      }
    }
    EXPECT_EQ(std::count(pixels.begin(), pixels.end(), 0), 0) << "only planes that are seen";
    const bool has_round_surfaces = kind == SceneKind::kCurved;
    EXPECT_EQ(cv::countNonZero(scene.labels < 0) > 0, has_round_surfaces);
  }
}

// A tangent of the surface: from the pixel on the left to the one on the right, or from above to
// below. On a smooth surface it is at right angles to the normal between them.
TEST(GeneratedScene, NormalsOfRoundSurfacesAreThoseOfTheirDisparities) {
  const GeneratedScene scene = MakeScene(SceneKind::kCurved, kSize, kDisparities, Ideal(), 12);
  const auto point = [&](int x, int y) {
    return scene.camera.PointAt(x, y, scene.disparity.at<float>(y, x));
  };
  int checked = 0;
  for (int y = 1; y < kSize.height - 1; ++y) {
    for (int x = 1; x < kSize.width - 1; ++x) {
      if (scene.labels.at<std::int16_t>(y, x) >= 0) continue;
      const Eigen::Vector3d n = NormalAt(scene, x, y);
      ASSERT_NEAR(n.norm(), 1.0, 1e-6);
      ASSERT_LT(n.dot(point(x, y)), 0.0) << "away from the camera";
      // Elsewhere the neighbours lie on another surface, or curvature is seen within a pixel.
      const bool smooth = (NormalAt(scene, x + 1, y) - NormalAt(scene, x - 1, y)).norm() < 0.02 &&
                          (NormalAt(scene, x, y + 1) - NormalAt(scene, x, y - 1)).norm() < 0.02;
      if (!smooth) continue;
      ASSERT_LT(std::abs(n.dot((point(x + 1, y) - point(x - 1, y)).normalized())), 0.01);
      ASSERT_LT(std::abs(n.dot((point(x, y + 1) - point(x, y - 1)).normalized())), 0.01);
      ++checked;
    }
  }
  EXPECT_GT(checked, kSize.area() / 4);
}

TEST(GeneratedScene, WorldRotationIsThatOfWallsAndFurniture) {
  for (const SceneKind kind : {SceneKind::kCorridor, SceneKind::kRoom}) {
    const GeneratedScene scene = MakeScene(kind, kSize, kDisparities, Ideal(), 13);
    const Eigen::Matrix3d rotation = scene.world_rotation;
    EXPECT_LT((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_GT(rotation(0, 2), std::sin(0.05)) << "seen turned to the right";
    Eigen::Vector3i facing = Eigen::Vector3i::Zero();
    for (const DisparityPlane& plane : scene.planes) {
      const Eigen::Vector3d along =
          (rotation.transpose() * scene.camera.ToSpace(plane).normal).cwiseAbs();
      Eigen::Index axis = 0;
      EXPECT_NEAR(along.maxCoeff(&axis), 1.0, 1e-9);
      ++facing[axis];
    }
    EXPECT_GE(facing.minCoeff(), 2) << "planes along all three directions";
  }
  const Eigen::Matrix3d room =
      MakeScene(SceneKind::kRoom, kSize, kDisparities, Ideal(), 13).world_rotation;
  EXPECT_GT(std::abs(room(0, 1)), std::sin(0.015)) << "rolled";
  EXPECT_GT(std::abs(room(2, 1)), std::sin(0.015)) << "pitched";
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
  constexpr int kWidth = 960;
  constexpr int kRange = 128;
  const GeneratedScene scene = MakeScene(SceneKind::kFence, {kWidth, 20}, kRange, Ideal(), 2);
  constexpr int kRow = 10;
  const auto disparity = [&](int x) { return scene.disparity.at<float>(kRow, x); };
  const auto right_x = [&](int x) { return static_cast<float>(x) - disparity(x); };
  const float bars = *std::max_element(scene.disparity.ptr<float>(kRow),
                                       scene.disparity.ptr<float>(kRow) + kWidth);
  const auto is_bar = [&](int x) { return disparity(x) > bars - 0.01F; };
  int hidden = 0;
  // Further right, bars that only the right camera sees may hide the wall.
  for (int x = 0; x < kWidth - kRange; ++x) {
    const int mask = scene.mask.at<std::uint8_t>(kRow, x);
    if (right_x(x) < 0) {
      EXPECT_EQ(mask, 128) << x;
      continue;
    }
    bool surely_hidden = false;  // between two pixels of one bar
    bool surely_seen = true;     // a pixel or more from any
    for (int bar = x + 1; bar + 1 < kWidth && !is_bar(x); ++bar) {
      if (!is_bar(bar)) continue;
      const float to_the_right = right_x(x) - right_x(bar);
      if (to_the_right >= 0.0F && to_the_right <= 1.0F && is_bar(bar + 1)) surely_hidden = true;
      if (std::abs(to_the_right) <= 1.0F) surely_seen = false;
    }
    // Between the two its exact place decides.
    if (surely_hidden || surely_seen) {
      EXPECT_EQ(mask, surely_hidden ? 128 : 255) << x;
    }
    if (surely_hidden) ++hidden;
  }
  EXPECT_GT(hidden, kWidth / 20);
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

TEST(SceneQuality, EachCameraHasItsOwnVignetting) {
  SceneQuality quality = Ideal();
  const GeneratedScene plain = MakeScene(SceneKind::kRoom, kSize, kDisparities, quality, 7);
  quality.vignetting = 0.2;
  quality.right_vignetting = 0.4;
  const GeneratedScene dim = MakeScene(SceneKind::kRoom, kSize, kDisparities, quality, 7);
  const auto ratio = [](const cv::Mat& image, const cv::Mat& reference, int x, int y) {
    return static_cast<double>(image.at<cv::Vec3b>(y, x)[1]) / reference.at<cv::Vec3b>(y, x)[1];
  };
  EXPECT_NEAR(ratio(dim.left, plain.left, 0, 0), 0.8, 0.02);
  EXPECT_NEAR(ratio(dim.right, plain.right, 0, 0), 0.6, 0.02);
  EXPECT_NEAR(ratio(dim.right, plain.right, kSize.width / 2, kSize.height / 2), 1.0, 0.02);
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
