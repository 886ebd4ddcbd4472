#include "refinement/plane_smoothing.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>
#include <hwy/targets.h>

namespace stereo_sgmp {
namespace {

constexpr int kRadius = 4;
constexpr int kStep = 2;

struct Sums {
  float n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0, e = 0, xe = 0, ye = 0;
};

int LargestDifference(const cv::Mat& image, cv::Point p, cv::Point q) {
  int largest = 0;
  const int channels = std::min(image.channels(), 3);
  for (int c = 0; c < channels; ++c) {
    const int a = image.ptr<std::uint8_t>(p.y)[p.x * image.channels() + c];
    const int b = image.ptr<std::uint8_t>(q.y)[q.x * image.channels() + c];
    largest = std::max(largest, std::abs(a - b));
  }
  return largest;
}

Sums ReferenceRowSums(const cv::Mat& image, const cv::Mat& valid, const cv::Mat& disparity,
                      cv::Point p, int dy) {
  Sums row;
  for (int dx = -kRadius; dx <= kRadius; dx += kStep) {
    const cv::Point q = p + cv::Point(dx, dy);
    if (!cv::Rect({0, 0}, disparity.size()).contains(q) || valid.at<std::uint8_t>(q) == 0) continue;
    const float e = disparity.at<float>(q) - disparity.at<float>(p);
    const int distance = std::max(std::abs(dx), std::abs(dy));
    if (std::abs(e) > 1.0f + 0.1f * static_cast<float>(distance)) continue;
    const float w = std::exp(-static_cast<float>(LargestDifference(image, p, q)) / 12.0f);
    const float fx = static_cast<float>(dx);
    row.n += w;
    row.x += w * fx;
    row.xx += w * fx * fx;
    row.e += w * e;
    row.xe += w * e * fx;
  }
  return row;
}

float ReferenceValue(const cv::Mat& image, const cv::Mat& valid, const cv::Mat& disparity,
                     cv::Point p) {
  Sums s;
  for (int dy = -kRadius; dy <= kRadius; dy += kStep) {
    const Sums row = ReferenceRowSums(image, valid, disparity, p, dy);
    const float fy = static_cast<float>(dy);
    s.n += row.n;
    s.x += row.x;
    s.y += row.n * fy;
    s.xx += row.xx;
    s.xy += row.x * fy;
    s.yy += row.n * fy * fy;
    s.e += row.e;
    s.xe += row.xe;
    s.ye += row.e * fy;
  }
  const float d = disparity.at<float>(p);
  if (s.n < 2.5f) return d;
  const float ridge = 0.3f * s.n;
  const float mx = s.x / s.n;
  const float my = s.y / s.n;
  const float me = s.e / s.n;
  const float xx = s.xx - s.x * mx + ridge;
  const float xy = s.xy - s.x * my;
  const float yy = s.yy - s.y * my + ridge;
  const float xe = s.xe - s.x * me;
  const float ye = s.ye - s.y * me;
  const float determinant = xx * yy - xy * xy;
  const float a = (xe * yy - ye * xy) / determinant;
  const float b = (ye * xx - xe * xy) / determinant;
  return d + std::clamp(me - a * mx - b * my, -1.0f, 1.0f);
}

cv::Mat ReferenceSmooth(const cv::Mat& image, const cv::Mat& valid, const cv::Mat& disparity) {
  cv::Mat smooth(disparity.size(), CV_32F);
  for (int y = 0; y < disparity.rows; ++y) {
    for (int x = 0; x < disparity.cols; ++x) {
      smooth.at<float>(y, x) = ReferenceValue(image, valid, disparity, {x, y});
    }
  }
  return smooth;
}

struct Scene {
  cv::Mat image;
  cv::Mat valid;
  cv::Mat disparity;
};

// A noisy slope with holes and a random image of some contrast.
Scene RandomScene(cv::Size size, int type) {
  cv::RNG random(17);
  Scene scene = {cv::Mat(size, type), cv::Mat(size, CV_8U), cv::Mat(size, CV_32F)};
  random.fill(scene.image, cv::RNG::UNIFORM, 90, 130);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      scene.disparity.at<float>(y, x) =
          0.2f * static_cast<float>(x) - 0.1f * static_cast<float>(y) + random.uniform(0.0f, 1.5f);
      scene.valid.at<std::uint8_t>(y, x) = random.uniform(0, 5) == 0 ? 0 : 255;
    }
  }
  return scene;
}

cv::Mat Smooth(const Scene& scene, int threads = 1) {
  ThreadPool pool(threads);
  cv::Mat disparity = scene.disparity.clone();
  PlaneSmoother().Smooth(scene.image, scene.valid, &disparity, &pool);
  return disparity;
}

TEST(PlaneSmoothingTest, EveryTargetEqualsTheScalarReferenceBitForBit) {
  for (const int type : {CV_8UC1, CV_8UC3, CV_8UC4}) {
    for (const cv::Size size : {cv::Size(1, 1), {1, 12}, {12, 1}, {3, 2}, {16, 5}, {61, 19}}) {
      const Scene scene = RandomScene(size, type);
      const cv::Mat expected = ReferenceSmooth(scene.image, scene.valid, scene.disparity);
      for (const auto target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        EXPECT_EQ(cv::norm(Smooth(scene, 2), expected, cv::NORM_INF), 0.0)
            << size << " type " << type << " " << hwy::TargetName(target);
      }
      hwy::SetSupportedTargetsForTest(0);
    }
  }
}

TEST(PlaneSmoothingTest, PlanesStayAndNoiseShrinks) {
  Scene scene = RandomScene({50, 40}, CV_8UC3);
  scene.image.setTo(cv::Scalar::all(100));
  scene.valid.setTo(255);
  cv::Mat plane(scene.disparity.size(), CV_32F);
  for (int y = 0; y < plane.rows; ++y) {
    for (int x = 0; x < plane.cols; ++x) {
      plane.at<float>(y, x) = 30.0f + 0.05f * static_cast<float>(x) - 0.08f * static_cast<float>(y);
    }
  }
  scene.disparity = plane.clone();
  const cv::Rect inner(4, 4, 42, 32);  // where windows are whole, the ridge does not bend planes
  EXPECT_LT(cv::norm(Smooth(scene)(inner), plane(inner), cv::NORM_INF), 1e-4);
  cv::Mat noise(plane.size(), CV_32F);
  cv::RNG(3).fill(noise, cv::RNG::UNIFORM, -0.4, 0.4);
  scene.disparity += noise;
  EXPECT_LT(cv::norm(Smooth(scene), plane), 0.4 * cv::norm(scene.disparity, plane));
}

TEST(PlaneSmoothingTest, StepsOfDisparityStaySharp) {
  Scene scene = RandomScene({40, 20}, CV_8UC1);
  scene.valid.setTo(255);
  scene.disparity.setTo(10);
  scene.disparity.colRange(20, 40).setTo(13);
  EXPECT_LT(cv::norm(Smooth(scene), scene.disparity, cv::NORM_INF), 1e-5);
}

TEST(PlaneSmoothingTest, InvalidPixelsDoNotPullTheirNeighbours) {
  Scene scene = RandomScene({20, 20}, CV_8UC1);
  scene.image.setTo(100);
  scene.valid.setTo(255);
  scene.disparity.setTo(10);
  scene.disparity.at<float>(10, 10) = 10.9f;
  scene.valid.at<std::uint8_t>(10, 10) = 0;
  const cv::Mat smooth = Smooth(scene);
  EXPECT_EQ(smooth.at<float>(10, 11), 10.0f);
  EXPECT_NEAR(smooth.at<float>(10, 10), 10.0f, 1e-5f);  // and are moved themselves
}

TEST(PlaneSmoothingTest, NoDisparityMovesByMoreThanOnePixel) {
  Scene scene = RandomScene({20, 20}, CV_8UC1);
  scene.image.setTo(100);
  scene.valid.setTo(255);
  scene.disparity.setTo(10);
  scene.disparity.at<float>(10, 10) = 11.35f;  // still near the neighbours four pixels away
  EXPECT_FLOAT_EQ(Smooth(scene).at<float>(10, 10), 10.35f);
}

TEST(PlaneSmoothingTest, BuffersAreReusedForAnotherSizeAndType) {
  ThreadPool pool(1);
  PlaneSmoother smoother;
  for (const cv::Size size : {cv::Size(40, 30), {9, 50}, {40, 30}}) {
    for (const int type : {CV_8UC3, CV_8UC1}) {
      const Scene scene = RandomScene(size, type);
      cv::Mat disparity = scene.disparity.clone();
      smoother.Smooth(scene.image, scene.valid, &disparity, &pool);
      EXPECT_EQ(cv::norm(disparity, Smooth(scene), cv::NORM_INF), 0.0);
    }
  }
}

}  // namespace
}  // namespace stereo_sgmp
