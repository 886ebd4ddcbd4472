#include "refinement/plane_propagation.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>
#include <hwy/targets.h>

namespace stereo_sgmp {
namespace {

// Weighted sums over pixels, counted from the pixel (at_x, at_y).
struct Moments {
  float n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0, e = 0, xe = 0, ye = 0;
};

// The same seen from a pixel (dx, dy) further; one of them is 0, the other 1 or -1.
Moments Moved(const Moments& s, int dx, int dy) {
  const float fx = static_cast<float>(dx);
  const float fy = static_cast<float>(dy);
  Moments m = s;
  m.x = s.x - fx * s.n;
  m.y = s.y - fy * s.n;
  m.xe = s.xe - fx * s.e;
  m.ye = s.ye - fy * s.e;
  m.xy = dx != 0 ? s.xy - fx * s.y : s.xy - fy * s.x;
  if (dx != 0) m.xx = s.xx - 2.0f * fx * s.x + s.n;
  if (dy != 0) m.yy = s.yy - 2.0f * fy * s.y + s.n;
  return m;
}

Moments Times(float f, const Moments& s) {
  return {f * s.n, f * s.x, f * s.y, f * s.xx, f * s.xy, f * s.yy, f * s.e, f * s.xe, f * s.ye};
}

Moments Plus(const Moments& a, const Moments& b) {
  return {a.n + b.n,   a.x + b.x, a.y + b.y,   a.xx + b.xx, a.xy + b.xy,
          a.yy + b.yy, a.e + b.e, a.xe + b.xe, a.ye + b.ye};
}

using Line = std::vector<Moments>;

// The sums of a line of pixels gathered along it; links[i] joins i - 1 and i.
Line GatherAlong(const Line& own, const std::vector<float>& links, int dx, int dy) {
  const std::size_t n = own.size();
  Line before = own;
  for (std::size_t i = 1; i < n; ++i) {
    before[i] = Plus(own[i], Times(links[i], Moved(before[i - 1], dx, dy)));
  }
  Line result = before;
  Moments after = own[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) {
    const Moments beyond = Times(links[i + 1], Moved(after, -dx, -dy));
    result[i] = Plus(before[i], beyond);
    after = Plus(own[i], beyond);
  }
  return result;
}

struct Scene {
  cv::Mat image;
  cv::Mat confidence;
  cv::Mat disparity;
};

float Link(const Scene& scene, cv::Point p, cv::Point q) {
  int difference = 0;
  const int channels = scene.image.channels();
  for (int c = 0; c < channels; ++c) {
    const int a = scene.image.ptr<std::uint8_t>(p.y)[p.x * channels + c];
    const int b = scene.image.ptr<std::uint8_t>(q.y)[q.x * channels + c];
    difference = std::max(difference, std::abs(a - b));
  }
  const float step = std::abs(scene.disparity.at<float>(p) - scene.disparity.at<float>(q));
  return std::exp(-(3.0f + static_cast<float>(difference)) / 40.0f) *
         std::min(1.0f, std::max(0.0f, 1.5f - 2.5f * step));
}

float PlaneValue(const Moments& s) {
  const float ridge = 0.1f * s.n;
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
  return me - a * mx - b * my;
}

// The sums of all pixels: along the rows, then along the columns.
std::vector<Line> GatherMoments(const Scene& scene) {
  const cv::Size size = scene.disparity.size();
  std::vector<Line> sums;
  for (int y = 0; y < size.height; ++y) {
    Line own(static_cast<std::size_t>(size.width));
    std::vector<float> links(own.size());
    for (int x = 0; x < size.width; ++x) {
      const float c = scene.confidence.at<float>(y, x);
      const float weight = ((c * c) * (c * c)) * ((c * c) * (c * c)) + 1e-6f;
      Moments& pixel = own[static_cast<std::size_t>(x)];
      pixel.n = weight;
      pixel.e = weight * scene.disparity.at<float>(y, x);
      if (x > 0) links[static_cast<std::size_t>(x)] = Link(scene, {x, y}, {x - 1, y});
    }
    sums.push_back(GatherAlong(own, links, 1, 0));
  }
  for (std::size_t x = 0; x < sums[0].size(); ++x) {
    Line own(sums.size());
    std::vector<float> links(own.size());
    for (std::size_t y = 0; y < own.size(); ++y) {
      own[y] = sums[y][x];
      const cv::Point p(static_cast<int>(x), static_cast<int>(y));
      if (y > 0) links[y] = Link(scene, p, p - cv::Point(0, 1));
    }
    const Line gathered = GatherAlong(own, links, 0, 1);
    for (std::size_t y = 0; y < own.size(); ++y) sums[y][x] = gathered[y];
  }
  return sums;
}

cv::Mat ReferencePropagate(Scene scene) {
  for (int round = 0; round < 2; ++round) {
    const std::vector<Line> sums = GatherMoments(scene);
    cv::Mat moved = scene.disparity.clone();
    for (int y = 0; y < moved.rows; ++y) {
      for (int x = 0; x < moved.cols; ++x) {
        float& d = moved.at<float>(y, x);
        const float plane =
            PlaneValue(sums[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)]);
        const float share =
            std::clamp(10.0f * (0.9f - scene.confidence.at<float>(y, x)), 0.0f, 1.0f);
        d += share * std::clamp(plane - d, -2.0f, 2.0f);
      }
    }
    scene.disparity = moved;
  }
  return scene.disparity;
}

// Two slopes with noise, a step between them, random confidence and an image of some contrast.
Scene RandomScene(cv::Size size, int type) {
  cv::RNG random(23);
  Scene scene = {cv::Mat(size, type), cv::Mat(size, CV_32F), cv::Mat(size, CV_32F)};
  random.fill(scene.image, cv::RNG::UNIFORM, 90, 130);
  random.fill(scene.confidence, cv::RNG::UNIFORM, 0.0, 1.0);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const float fx = static_cast<float>(x);
      const float fy = static_cast<float>(y);
      const float surface = 2 * x < size.width ? 40.0f + 0.1f * fx : 30.0f - 0.05f * fy;
      scene.disparity.at<float>(y, x) = surface + random.uniform(0.0f, 0.8f);
    }
  }
  return scene;
}

// An even image with the sure plane 20 + x / 10 - y / 20.
Scene SurePlane(cv::Size size) {
  Scene scene = {cv::Mat(size, CV_8UC3, cv::Scalar::all(100)),
                 cv::Mat(size, CV_32F, cv::Scalar(0.95)), cv::Mat(size, CV_32F)};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      scene.disparity.at<float>(y, x) =
          20.0f + 0.1f * static_cast<float>(x) - 0.05f * static_cast<float>(y);
    }
  }
  return scene;
}

cv::Mat Propagate(const Scene& scene, int threads = 1) {
  ThreadPool pool(threads);
  cv::Mat disparity = scene.disparity.clone();
  PlanePropagation().Apply(scene.image, scene.confidence, &disparity, &pool);
  return disparity;
}

TEST(PlanePropagationTest, EveryTargetEqualsTheScalarReferenceBitForBit) {
  for (const int type : {CV_8UC1, CV_8UC3}) {
    for (const cv::Size size : {cv::Size(1, 1), {1, 12}, {12, 1}, {3, 2}, {16, 5}, {61, 19}}) {
      const Scene scene = RandomScene(size, type);
      const cv::Mat expected = ReferencePropagate(scene);
      for (const auto target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        EXPECT_EQ(cv::norm(Propagate(scene, 2), expected, cv::NORM_INF), 0.0)
            << size << " type " << type << " " << hwy::TargetName(target);
      }
      hwy::SetSupportedTargetsForTest(0);
    }
  }
}

TEST(PlanePropagationTest, UnsureWavesSettleOnThePlaneAroundThem) {
  Scene scene = SurePlane({90, 60});
  const cv::Mat plane = scene.disparity.clone();
  const cv::Rect unsure(25, 15, 40, 30);
  scene.confidence(unsure).setTo(0.4);
  for (int x = unsure.x; x < unsure.br().x; ++x) {
    const float along = static_cast<float>(x - unsure.x) / static_cast<float>(unsure.width);
    scene.disparity(unsure).col(x - unsure.x) += 0.8f * std::sin(3.1416f * along);
  }
  EXPECT_GT(cv::norm(scene.disparity, plane, cv::NORM_INF), 0.79);
  EXPECT_LT(cv::norm(Propagate(scene), plane, cv::NORM_INF), 0.1);
}

TEST(PlanePropagationTest, SurePixelsStay) {
  Scene scene = RandomScene({40, 30}, CV_8UC3);
  scene.confidence.setTo(0.9);
  EXPECT_EQ(cv::norm(Propagate(scene), scene.disparity, cv::NORM_INF), 0.0);
}

TEST(PlanePropagationTest, StepsOfDisparitySeparateSurfaces) {
  Scene scene = SurePlane({60, 40});
  scene.disparity.colRange(30, 60) += 3.0f;
  scene.confidence.colRange(30, 60).setTo(0.3);  // the unsure side could only lose
  EXPECT_LT(cv::norm(Propagate(scene), scene.disparity, cv::NORM_INF), 0.02);
}

TEST(PlanePropagationTest, ColorEdgesWeakenTheLink) {
  Scene scene = SurePlane({60, 40});
  scene.disparity.setTo(20.0);
  scene.disparity.colRange(0, 30).setTo(20.2);
  scene.confidence.colRange(30, 60).setTo(0.5);
  const float even = Propagate(scene).at<float>(20, 40);
  scene.image.colRange(30, 60).setTo(cv::Scalar::all(250));
  const float edge = Propagate(scene).at<float>(20, 40);
  EXPECT_GT(even, 20.1f);
  EXPECT_LT(edge, even - 0.05f);
}

TEST(PlanePropagationTest, BuffersAreReusedForAnotherSizeAndType) {
  ThreadPool pool(1);
  PlanePropagation propagation;
  for (const cv::Size size : {cv::Size(40, 30), {9, 50}, {40, 30}}) {
    for (const int type : {CV_8UC3, CV_8UC1}) {
      const Scene scene = RandomScene(size, type);
      cv::Mat disparity = scene.disparity.clone();
      propagation.Apply(scene.image, scene.confidence, &disparity, &pool);
      EXPECT_EQ(cv::norm(disparity, Propagate(scene), cv::NORM_INF), 0.0);
    }
  }
}

}  // namespace
}  // namespace stereo_sgmp
