#include "matcher/repeating_pair.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace stereo_sgmp {
namespace {

// Columns and rows in which the left image shows it, disparity d = at_zero + slope * x_left.
struct Panel {
  double x_begin;
  double x_end;
  double y_begin;
  double y_end;
  double at_zero;
  double slope;
  double period;
  int seed;
};

// The same number in 0..1 for the same arguments.
double Random(int x, int y, int seed) {
  auto h = static_cast<std::uint32_t>(x) * 374761393U + static_cast<std::uint32_t>(y) * 668265263U +
           static_cast<std::uint32_t>(seed) * 2246822519U;
  h = (h ^ (h >> 13)) * 1274126177U;
  return ((h ^ (h >> 16)) & 0xFFFFU) / 65535.0;
}

// Smooth random numbers, 0..1, with features of `size` pixels.
double Cloud(double x, double y, double size, int seed) {
  const double column = std::floor(x / size);
  const double row = std::floor(y / size);
  const double u = x / size - column;
  const double v = y / size - row;
  const int i = static_cast<int>(column);
  const int j = static_cast<int>(row);
  const double upper = (1.0 - u) * Random(i, j, seed) + u * Random(i + 1, j, seed);
  const double lower = (1.0 - u) * Random(i, j + 1, seed) + u * Random(i + 1, j + 1, seed);
  return (1.0 - v) * upper + v * lower;
}

double Remainder(double x, double period) { return x - period * std::floor(x / period); }

double Tiles(double x, double y, double period, int seed) {
  const double u = Remainder(x, period);
  const double v = Remainder(y, 1.3 * period);
  const double joint = 0.15 * period;
  return (u < joint || v < joint ? 60.0 : 150.0) + 30.0 * Cloud(u, v, period / 4.0, seed);
}

// Averaged over the width of a pixel.
double PixelOf(const Panel& panel, double x, double y, double stains) {
  double sum = 0.0;
  for (const double shift : {-0.375, -0.125, 0.125, 0.375}) {
    sum += Tiles(x + shift, y, panel.period, panel.seed);
    sum += stains * (Cloud(x + shift, y, 4.0, panel.seed + 50) - 0.5);
    sum += stains * (Cloud(x + shift, y, 9.0, panel.seed + 90) - 0.5);
  }
  return sum / 4.0;
}

cv::Mat ViewOf(const std::vector<Panel>& panels, cv::Size size, bool right, double stains) {
  cv::Mat view(size, CV_8U);
  cv::RNG noise(right ? 2 : 1);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      double nearest = -1e9;
      double value = 0.0;
      for (const Panel& panel : panels) {
        const double x_left = right ? (x + panel.at_zero) / (1.0 - panel.slope) : x;
        const double disparity = panel.at_zero + panel.slope * x_left;
        if (x_left < panel.x_begin || x_left >= panel.x_end || y < panel.y_begin ||
            y >= panel.y_end || disparity < nearest) {
          continue;
        }
        nearest = disparity;
        value = PixelOf(panel, x_left, y, stains);
      }
      view.at<std::uint8_t>(y, x) = cv::saturate_cast<std::uint8_t>(value + noise.gaussian(2.0));
    }
  }
  return view;
}

}  // namespace

RepeatingPair MakeRepeatingPair(cv::Size size, double period, double stains) {
  const double w = size.width;
  const double h = size.height;
  const std::vector<Panel> panels{
      {-w, 3.0 * w, 0.0, h, 10.0, 4.8 / w, period, 0},
      {0.25 * w, 0.58 * w, 0.22 * h, h, 24.0, 0.0, 0.9 * period, 1},
      {0.62 * w, 0.8 * w, 0.11 * h, 0.67 * h, 32.0, 0.0, 1.2 * period, 2}};
  return {ViewOf(panels, size, false, stains), ViewOf(panels, size, true, stains)};
}

cv::Mat RepeatingWall(cv::Size size, double period, double disparity) {
  cv::Mat wall(size, CV_8U);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      wall.at<std::uint8_t>(y, x) =
          cv::saturate_cast<std::uint8_t>(Tiles(x + disparity, y, period, 0));
    }
  }
  return wall;
}

}  // namespace stereo_sgmp
