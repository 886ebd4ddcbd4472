#include "aggregation/reference_aggregation.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace stereo_sgmp::reference {
namespace {

using Costs = std::vector<int>;  // of one pixel, by disparity index

// Path cost of disparities that a pixel does not reach.
constexpr int kUnreached = 1 << 20;

// Sums in bytes stay at it where they would exceed it.
constexpr int kMostInBytes = 255;

int ContrastOf(const cv::Mat& guide, int x1, int y1, int x2, int y2) {
  int contrast = 0;
  const int channels = guide.channels();
  for (int c = 0; c < channels; ++c) {
    const int a = guide.ptr(y1)[x1 * channels + c];
    const int b = guide.ptr(y2)[x2 * channels + c];
    contrast = std::max(contrast, std::abs(a - b));
  }
  return contrast;
}

// Disparities that pixel x is matched at: in blocks of 64, up to that of the last one whose match
// lies inside the right image.
int Reached(const VolumeShape& shape, int x) {
  int reached = 64;
  while (x - shape.min_disparity - reached >= 0) reached += 64;
  return std::min(reached, shape.disparities);
}

// V(d, d'), Eq. 2.
int V(int d, int other, int p1, int p2) {
  if (d == other) return 0;
  return std::abs(d - other) == 1 ? p1 : p2;
}

// The paths of one of the two sweeps of the library.
using Sweep = std::vector<PathStep>;

// S(p, d) = minima(p) + least(p) + excess(p, d).
struct Sums {
  int step = 1;               // all are in steps of so many units of the costs
  std::vector<int> minima;    // sum over r of min_d L_r(p, d)
  std::vector<int> least;     // sum over the sweeps of the least of the rest
  std::vector<Costs> excess;  // in bytes at most kMostInBytes

  int Base(std::size_t pixel) const { return minima[pixel] + least[pixel]; }
};

int Limited(int sum, int step) { return step == 1 ? sum : std::min(sum, kMostInBytes); }

class Aggregation {
 public:
  Aggregation(const Volume& volume, const cv::Mat& guide, const AggregationOptions& options,
              JumpFunction jump, int slack)
      : volume_(volume),
        guide_(guide),
        options_(options),
        jump_(std::move(jump)),
        p1_(InUnits(options.p1)),
        slack_(slack < 0 ? -1 : InUnits(slack)) {}

  Sums Sum(const std::vector<Sweep>& sweeps) const {
    const std::size_t pixels = PixelCount();
    const auto disparities = static_cast<std::size_t>(volume_.shape.disparities);
    Sums sums;
    sums.step = FitsBytes() ? 2 : 1;
    sums.minima.assign(pixels, 0);
    sums.least.assign(pixels, 0);
    sums.excess.assign(pixels, Costs(disparities, 0));
    for (const Sweep& sweep : sweeps) AddSweep(sweep, &sums);
    for (std::size_t q = 0; q < pixels; ++q) {
      sums.minima[q] /= sums.step;
      for (int& excess : sums.excess[q]) excess = Limited(excess, sums.step);
    }
    return sums;
  }

 private:
  std::size_t PixelCount() const {
    return static_cast<std::size_t>(volume_.shape.width * volume_.shape.height);
  }

  // Whether the largest path cost, C + P2, fits 8 bits.
  bool FitsBytes() const {
    const int largest = (255 + volume_.unit / 2) / volume_.unit;
    return largest + InUnits(options_.p1 * (1.0 + options_.alpha)) <= 255;
  }

  // What the costs of the paths exceed their least by. In 8 bits: in steps of two, two paths at a
  // time by their mean, rounded up, and at most the largest number.
  void AddSweep(const Sweep& sweep, Sums* sums) const {
    std::vector<std::vector<Costs>> paths;
    for (const PathStep step : sweep) paths.push_back(ExcessAlong(step, &sums->minima));
    for (std::size_t q = 0; q < PixelCount(); ++q) {
      Costs half(sums->excess[q].size(), 0);
      for (std::size_t d = 0; d < half.size(); ++d) {
        for (std::size_t i = 0; i < paths.size(); i += 2) {
          const int pair = paths[i][q][d] + paths[i + 1][q][d];
          half[d] += sums->step == 1 ? pair : (pair + 1) / 2;
        }
        half[d] = Limited(half[d], sums->step);
      }
      const int least = *std::min_element(half.begin(), half.end());
      sums->least[q] += least;
      for (std::size_t d = 0; d < half.size(); ++d) sums->excess[q][d] += half[d] - least;
    }
  }

  // L_r(p, d) - min_d' L_r(p, d') of all pixels; adds the latter to `minima`.
  std::vector<Costs> ExcessAlong(PathStep step, std::vector<int>* minima) const {
    std::vector<Costs> path = CostsAlong(step);
    for (std::size_t q = 0; q < path.size(); ++q) {
      const int least = *std::min_element(path[q].begin(), path[q].end());
      for (int& cost : path[q]) cost -= least;
      (*minima)[q] += least;
    }
    return path;
  }

  std::vector<Costs> CostsAlong(PathStep step) const {
    const int width = volume_.shape.width;
    const int height = volume_.shape.height;
    std::vector<Costs> path(PixelCount());
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        const int y = step.dy < 0 ? height - 1 - v : v;
        const int x = step.dx < 0 ? width - 1 - u : u;
        const int px = x - step.dx;
        const int py = y - step.dy;
        const bool inside = px >= 0 && px < width && py >= 0 && py < height;
        const auto q = static_cast<std::size_t>(y * width + x);
        const Costs* predecessor =
            inside ? &path[static_cast<std::size_t>(py * width + px)] : nullptr;
        path[q] = PathCosts(x, y, step, predecessor);
      }
    }
    return path;
  }

  int InUnits(double value) const { return static_cast<int>(std::lround(value / volume_.unit)); }

  // Eq. 3, less the predecessor's minimum, with V_S (Eqs. 8 and 12) as the least way from d to d':
  // a step to some t at the predecessor and the free jump j(t) from there, a step alone for the
  // price of the slack, or P2.
  Costs PathCosts(int x, int y, PathStep step, const Costs* predecessor) const {
    const auto disparities = static_cast<std::size_t>(volume_.shape.disparities);
    if (predecessor == nullptr) return AddCosts(x, y, Costs(disparities, 0), 0);
    const int contrast = ContrastOf(guide_, x, y, x - step.dx, y - step.dy);
    const int p2 =
        InUnits(options_.p1 * (1.0 + options_.alpha * std::exp(-contrast / options_.beta)));
    const int minimum = *std::min_element(predecessor->begin(), predecessor->end());
    Costs best(disparities, minimum + p2);
    // A step alone ends at a disparity that p reaches.
    for (int t = 0; t < Reached(volume_.shape, x - step.dx); ++t) {
      const int stepped = AfterStep(*predecessor, t, p2);
      const int j = jump_ ? jump_(x, y, step, t) : 0;
      if (t + j >= 0 && t + j < volume_.shape.disparities) Lower(stepped, t + j, &best);
      if (slack_ >= 0) Lower(stepped + slack_, t, &best);
    }
    return AddCosts(x, y, best, minimum);
  }

  int AfterStep(const Costs& predecessor, int t, int p2) const {
    int least = std::numeric_limits<int>::max();
    for (int from = 0; from < volume_.shape.disparities; ++from) {
      least = std::min(least, predecessor[static_cast<std::size_t>(from)] + V(from, t, p1_, p2));
    }
    return least;
  }

  static void Lower(int cost, int d, Costs* costs) {
    int& entry = (*costs)[static_cast<std::size_t>(d)];
    entry = std::min(entry, cost);
  }

  Costs AddCosts(int x, int y, Costs best, int minimum) const {
    const int reached = Reached(volume_.shape, x);
    for (int d = 0; d < reached; ++d) {
      best[static_cast<std::size_t>(d)] += volume_.At(x, y, d) - minimum;
    }
    std::fill(best.begin() + reached, best.end(), kUnreached);
    return best;
  }

  const Volume& volume_;
  const cv::Mat& guide_;
  const AggregationOptions& options_;
  JumpFunction jump_;
  int p1_;
  int slack_;
};

Volume Sharpen(const Volume& volume, const Sums& sums) {
  Volume sharpened = volume;
  const auto disparities = static_cast<std::size_t>(volume.shape.disparities);
  const int weight = 31 * sums.step;
  for (std::size_t pixel = 0; pixel < sums.excess.size(); ++pixel) {
    const Costs& s = sums.excess[pixel];
    const int best = *std::min_element(s.begin(), s.end());
    for (std::size_t d = 0; d < disparities; ++d) {
      const int raised = std::min(s[d] - best, 65535 / weight) * weight / 256;
      const int half = volume.costs[pixel * disparities + d] / 2;
      sharpened.costs[pixel * disparities + d] =
          static_cast<std::uint8_t>(std::min(255 / volume.unit, half + raised));
    }
  }
  return sharpened;
}

std::uint16_t CostOrNone(const Costs& s, int d, int unit) {
  if (d < 0 || d >= static_cast<int>(s.size())) return WinnerMap::kNone;
  return static_cast<std::uint16_t>(s[static_cast<std::size_t>(d)] * unit);
}

// What the left pixels that match one right pixel are compared by; in bytes half of S, rounded up.
int OfferOf(const Sums& sums, std::size_t pixel, std::size_t d) {
  if (sums.step == 1) return sums.Base(pixel) + sums.excess[pixel][d];
  return (sums.excess[pixel][d] + Limited(sums.Base(pixel), sums.step) + 1) / 2;
}

void FindWinners(const Volume& volume, const Sums& sums, WinnerMap* map) {
  const VolumeShape& shape = volume.shape;
  const int unit = volume.unit * sums.step;
  map->Create(shape);
  cv::Mat_<int> right_cost(shape.height, shape.width, std::numeric_limits<int>::max());
  map->right_winner.setTo(WinnerMap::kNone);
  for (int y = 0; y < shape.height; ++y) {
    for (int x = 0; x < shape.width; ++x) {
      const auto pixel = static_cast<std::size_t>(y * shape.width + x);
      const int reached = Reached(shape, x);
      Costs s = sums.excess[pixel];
      s.resize(static_cast<std::size_t>(reached));
      for (int& sum : s) sum += sums.Base(pixel);
      const int winner = static_cast<int>(std::min_element(s.begin(), s.end()) - s.begin());
      int second = -1;
      for (int d = 0; d < reached; ++d) {
        const bool is_near = std::abs(d - winner) <= 1;
        if (!is_near &&
            (second < 0 || s[static_cast<std::size_t>(d)] < s[static_cast<std::size_t>(second)]))
          second = d;
        const int right_x = x - shape.min_disparity - d;
        if (right_x < 0 || right_x >= shape.width) continue;
        int& best = right_cost(y, right_x);
        const int offer = OfferOf(sums, pixel, static_cast<std::size_t>(d));
        if (sums.step != 1 && offer >= kMostInBytes) continue;  // which is as good as none
        // Left pixels come from left to right, that is from small to large disparities.
        if (offer < best) {
          best = offer;
          map->right_winner(y, right_x) = static_cast<std::uint16_t>(d);
        }
      }
      map->winner(y, x) = static_cast<std::uint16_t>(winner);
      map->cost(y, x) = CostOrNone(s, winner, unit);
      map->cost_below(y, x) = CostOrNone(s, winner - 1, unit);
      map->cost_above(y, x) = CostOrNone(s, winner + 1, unit);
      map->second(y, x) = CostOrNone(s, second, unit);
      const int excess = s[static_cast<std::size_t>(winner)] - sums.minima[pixel];
      map->uncertainty(y, x) = CostOrNone({excess}, 0, unit);
    }
  }
}

}  // namespace

WinnerMap Aggregate(const Volume& volume, const cv::Mat& guide, const AggregationOptions& options,
                    const JumpFunction& jump, int jump_slack) {
  const std::vector<Sweep> axes{{{1, 0}, {0, 1}}, {{-1, 0}, {0, -1}}};
  const std::vector<Sweep> all{{{1, 0}, {0, 1}, {1, 1}, {-1, 1}},
                               {{-1, 0}, {0, -1}, {-1, -1}, {1, -1}}};
  WinnerMap map;
  if (options.scheme != PathScheme::kFourTwice) {
    const bool eight = options.scheme == PathScheme::kEight;
    const Aggregation aggregation(volume, guide, options, jump, jump_slack);
    FindWinners(volume, aggregation.Sum(eight ? all : axes), &map);
    return map;
  }
  const Aggregation first(volume, guide, options, jump, jump_slack);
  const Volume sharpened = Sharpen(volume, first.Sum(axes));
  const Aggregation second(sharpened, guide, options, jump, jump_slack);
  FindWinners(sharpened, second.Sum(axes), &map);
  return map;
}

}  // namespace stereo_sgmp::reference
