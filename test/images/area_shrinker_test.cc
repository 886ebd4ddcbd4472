#include "images/area_shrinker.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <opencv2/imgproc.hpp>

namespace stereo_sgmp {
namespace {

#if HWY_ARCH_ARM
// OpenCV's own sums are fused there, which rounds one value of some of these images the other way.
constexpr double kMostLevels = 1.0;
#else
constexpr double kMostLevels = 0.0;
#endif

TEST(AreaShrinkerTest, EqualsOpenCvOnAnyNumberOfThreadsAndTarget) {
  ThreadPool one(1);
  ThreadPool three(3);
  AreaShrinker shrinker;
  cv::RNG rng(1);
  const cv::Size sizes[][2] = {{{144, 99}, {36, 25}}, {{128, 72}, {43, 24}}, {{97, 31}, {31, 30}},
                               {{64, 48}, {32, 24}},  {{50, 3}, {17, 1}},    {{7, 5}, {7, 4}},
                               {{1, 9}, {1, 2}},      {{300, 201}, {19, 13}}};
  for (const auto& [from, to] : sizes) {
    for (const int type : {CV_8UC1, CV_8UC3}) {
      cv::Mat image(from, type);
      rng.fill(image, cv::RNG::UNIFORM, 0, 256);
      cv::Mat expected;
      cv::resize(image, expected, to, 0, 0, cv::INTER_AREA);
      for (ThreadPool* pool : {&one, &three}) {
        for (const auto target : hwy::SupportedAndGeneratedTargets()) {
          hwy::SetSupportedTargetsForTest(target);
          cv::Mat shrunk;
          shrinker.Shrink(image, to, &shrunk, pool);
          hwy::SetSupportedTargetsForTest(0);
          EXPECT_LE(cv::norm(shrunk, expected, cv::NORM_L1), kMostLevels)
              << from << " to " << to << " " << hwy::TargetName(target);
        }
      }
    }
  }
}

}  // namespace
}  // namespace stereo_sgmp
