#ifndef STEREO_SGMP_TEST_ALIGNMENT_TEXTURED_PAIR_H_
#define STEREO_SGMP_TEST_ALIGNMENT_TEXTURED_PAIR_H_

#include <cmath>
#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

namespace stereo_sgmp {

// A texture that can be asked for anywhere: a sum of waves.
class Texture {
 public:
  explicit Texture(std::uint64_t seed) {
    cv::RNG rng(seed);
    for (int i = 0; i < 40; ++i) {
      const double frequency = 2.0 * CV_PI / rng.uniform(6.0, 40.0);
      const double direction = rng.uniform(0.0, CV_PI);
      waves_.push_back({frequency * std::cos(direction), frequency * std::sin(direction),
                        rng.uniform(0.0, 2.0 * CV_PI)});
    }
  }

  double At(double x, double y) const {
    double sum = 128.0;
    for (const Wave& wave : waves_) sum += 10.0 * std::sin(wave.x * x + wave.y * y + wave.phase);
    return sum;
  }

 private:
  struct Wave {
    double x, y, phase;
  };
  std::vector<Wave> waves_;
};

struct TexturedPair {
  cv::Mat left;
  cv::Mat right;
};

// A fronto-parallel plane at `disparity`, where row y of the left image is row a y + b of the
// right one, with gray levels multiplied by `gain` there.
inline TexturedPair MakePair(cv::Size size, double disparity, double a, double b, double gain = 1.0,
                             std::uint64_t seed = 1) {
  const Texture texture(seed);
  TexturedPair pair{cv::Mat(size, CV_8UC1), cv::Mat(size, CV_8UC1)};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      pair.left.at<std::uint8_t>(y, x) = cv::saturate_cast<std::uint8_t>(texture.At(x, y));
      pair.right.at<std::uint8_t>(y, x) =
          cv::saturate_cast<std::uint8_t>(gain * texture.At(x + disparity, (y - b) / a));
    }
  }
  return pair;
}

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_TEST_ALIGNMENT_TEXTURED_PAIR_H_
