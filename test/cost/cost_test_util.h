#ifndef STEREO_SGMP_TEST_COST_COST_TEST_UTIL_H_
#define STEREO_SGMP_TEST_COST_COST_TEST_UTIL_H_

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <hwy/targets.h>
#include <opencv2/core.hpp>

#include "common/aligned_buffer.h"
#include "cost/cost_rows.h"

namespace stereo_sgmp {

// Sizes around the ends of vectors, disparity counts around their padding, and ranges that lie
// partly or wholly outside the image.
inline std::vector<VolumeShape> AwkwardShapes() {
  const int sizes[][2] = {{1, 1}, {1, 7}, {17, 5}, {65, 9}, {130, 12}};
  std::vector<VolumeShape> shapes;
  for (const auto& size : sizes) {
    for (const int disparities : {1, 2, 31, 64, 65, 200, 300}) {
      for (const int min_disparity : {0, 7, -9, 500, -500}) {
        shapes.push_back({size[0], size[1], disparities, min_disparity});
      }
    }
  }
  return shapes;
}

inline std::string Describe(const VolumeShape& shape) {
  return std::to_string(shape.width) + "x" + std::to_string(shape.height) + ", " +
         std::to_string(shape.disparities) + " disparities from " +
         std::to_string(shape.min_disparity);
}

// Noise with flat, dark and bright parts, so that saturation and zero variance occur.
inline cv::Mat RandomGray(int width, int height, std::uint64_t seed) {
  cv::RNG rng(seed);
  cv::Mat image(height, width, CV_8UC1);
  rng.fill(image, cv::RNG::UNIFORM, -100, 356);
  image.colRange(width / 2, width / 2 + width / 8).setTo(77);
  return image;
}

// Runs `test` once with each SIMD target this machine has as the only one.
inline void ForEachTarget(const std::function<void()>& test) {
  const std::int64_t all = hwy::SupportedTargets();
  for (std::int64_t rest = all; rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    test();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

// Reference cost of pixel (x, y) matched with column x - d of the right image, which may lie
// outside of it.
using ReferenceCost = std::function<int(int x, int y, int match)>;

// The reference costs of a volume, which all targets shall give.
class ExpectedCosts {
 public:
  ExpectedCosts(const VolumeShape& shape, const ReferenceCost& reference)
      : disparities_(shape.disparities), width_(shape.width) {
    for (int y = 0; y < shape.height; ++y) {
      for (int x = 0; x < shape.width; ++x) {
        for (int k = 0; k < shape.disparities; ++k) {
          costs_.push_back(reference(x, y, x - shape.min_disparity - k));
        }
      }
    }
  }

  // Of all disparities of a pixel.
  const int* At(int x, int y) const {
    return costs_.data() + (static_cast<std::ptrdiff_t>(y) * width_ + x) * disparities_;
  }

 private:
  std::ptrdiff_t disparities_;
  int width_;
  std::vector<int> costs_;
};

// Compares all costs with those expected, asking for them in stretches of several lengths.
inline void ExpectCosts(const CostRows& costs, const ExpectedCosts& expected) {
  const VolumeShape& shape = costs.shape();
  AlignedBuffer<std::uint8_t> scratch;
  for (int y = 0; y < shape.height; ++y) {
    const int length = 1 + (y * 13) % 40;
    for (int begin = 0; begin < shape.width; begin += length) {
      const int end = std::min(begin + length, shape.width);
      scratch.Resize(static_cast<std::size_t>((end - begin) * shape.Stride()));
      const std::uint8_t* row = costs.Row(y, begin, end, scratch.data());
      for (int x = begin; x < end; ++x) {
        const std::uint8_t* pixel = row + (x - begin) * shape.Stride();
        const auto [cost, reference] =
            std::mismatch(pixel, pixel + shape.disparities, expected.At(x, y));
        if (cost == pixel + shape.disparities) continue;
        FAIL() << Describe(shape) << " at x " << x << ", y " << y << ", index " << cost - pixel
               << ": " << int{*cost} << ", expected " << *reference;
      }
    }
  }
}

inline void ExpectCosts(const CostRows& costs, const ReferenceCost& reference) {
  ExpectCosts(costs, ExpectedCosts(costs.shape(), reference));
}

// What full costs become in units of `unit`: rounded, halves upwards.
inline ReferenceCost InUnits(const ReferenceCost& full, int unit) {
  return [full, unit](int x, int y, int match) {
    return static_cast<int>(std::floor(full(x, y, match) / static_cast<double>(unit) + 0.5));
  };
}

// The pixel, or the nearest one of the image.
inline int Clamped(const cv::Mat& image, int x, int y) {
  return image.at<std::uint8_t>(std::clamp(y, 0, image.rows - 1), std::clamp(x, 0, image.cols - 1));
}

// Hamming distance of the census windows around (x, y) and (match, y).
inline int ReferenceHamming(const cv::Mat& left, const cv::Mat& right, int radius_x, int radius_y,
                            int x, int y, int match) {
  int distance = 0;
  for (int dy = -radius_y; dy <= radius_y; ++dy) {
    for (int dx = -radius_x; dx <= radius_x; ++dx) {
      const bool l = Clamped(left, x + dx, y + dy) > Clamped(left, x, y);
      const bool r = Clamped(right, match + dx, y + dy) > Clamped(right, match, y);
      if (l != r) ++distance;
    }
  }
  return distance;
}

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_TEST_COST_COST_TEST_UTIL_H_
