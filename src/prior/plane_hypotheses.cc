#include "prior/plane_hypotheses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "prior/plane_sets.h"

namespace stereo_sgmp {
namespace {

// Half width of the window a seed plane is fitted to, coarse pixels.
constexpr int kSeedRadius = 5;
constexpr int kSeedSide = 2 * kSeedRadius + 1;
constexpr int kSeedColumns = kSeedSide + 1;  // summed; whole vectors, the last is not used
constexpr int kSeedWindow = kSeedSide * kSeedSide;
// Distance of the windows' centres in x and y.
constexpr int kSeedStep = 3;
// A window holds the disparities this close to that of its centre; wide enough for a slant of
// 0.4 a pixel, narrow enough to leave out most of what lies behind.
constexpr float kSeedRange = 2.0F;
// Share of the window that must be filled, and what each missing share costs in the ranking.
constexpr double kSeedFill = 0.6;
constexpr double kMissingPenalty = 0.1;
// Distance from the plane at which a pixel still belongs to it, coarse disparities.
constexpr float kGrowRange = 0.6F;
// Residuals that fill this range evenly have a root mean square of 0.35: near that the region is
// no plane but whatever the range happened to cut out.
constexpr double kMaxRms = 0.3;
// Pixels without a fitting disparity that growth steps over, less one.
constexpr int kGap = 2;
static_assert(2 * kGap + 1 == BitRows::kWindow, "of the pixels around one");
// The plane is fitted again each time its region has become this much larger.
constexpr double kRefitGrowth = 1.5;
// Final fit: residuals beyond this count less, coarse disparities.
constexpr double kHuberThreshold = 0.5;
constexpr int kHuberIterations = 2;

constexpr int kPadding = std::max(kSeedRadius + 1, kGap);

void CheckInputs(const CoarseDisparity& coarse) {
  if (coarse.disparity.type() != CV_32FC1 || coarse.confident.type() != CV_8UC1) {
    throw std::invalid_argument(
        "Plane hypotheses need a CV_32F disparity and a CV_8U confidence mask; convert them "
        "first.");
  }
  if (coarse.disparity.size() != coarse.confident.size()) {
    throw std::invalid_argument(
        "The coarse disparity and its confidence mask differ in size; pass maps of one pass.");
  }
}

// Moments of the window around `centre`, relative to it, of the disparities near its own. Sums
// each column apart, so that the compiler vectorises across them.
PlaneMoments WindowMoments(const float* centre, int stride) {
  struct ColumnSums {
    std::array<float, kSeedColumns> n{}, y{}, d{}, yy{}, yd{}, dd{};
  } sums;
  for (int dy = -kSeedRadius; dy <= kSeedRadius; ++dy) {
    const float* row = centre + dy * stride - kSeedRadius;
    const float v = static_cast<float>(dy);
    for (std::size_t i = 0; i < kSeedColumns; ++i) {
      const float difference = row[i] - *centre;
      const bool near = std::abs(difference) < kSeedRange;
      const float n = near ? 1.0F : 0.0F;
      const float d = near ? difference : 0.0F;
      sums.n[i] += n;
      sums.y[i] += n * v;
      sums.d[i] += d;
      sums.yy[i] += n * v * v;
      sums.yd[i] += d * v;
      sums.dd[i] += d * d;
    }
  }
  PlaneMoments moments;
  for (std::size_t i = 0; i < kSeedSide; ++i) {
    const double dx = static_cast<double>(i) - kSeedRadius;
    moments.AddColumn(dx, {sums.n[i], sums.y[i], sums.d[i], sums.yy[i], sums.yd[i], sums.dd[i]});
  }
  return moments;
}

}  // namespace

int SmallestPlane(const PriorOptions& options, cv::Size size) {
  return std::min(options.min_plane_area, std::max(1, size.area() / 50));
}

void PlaneHypotheses::Find(const CoarseDisparity& coarse, int min_area, ThreadPool* threads) {
  CheckInputs(coarse);
  Load(coarse);
  FindSeeds(threads);
  for (const Seed& seed : seeds_) {
    if (map_.planes.size() >= PlaneSet::kMaxListed) break;
    if (reached_[static_cast<std::size_t>(Index(seed.x, seed.y))] != 0) continue;
    Grow(seed);
    if (!Keep(min_area)) Release(pixels_.begin());
  }
  SortByArea();
}

int PlaneHypotheses::Index(int x, int y) const { return (y + kPadding) * stride_ + x + kPadding; }

void PlaneHypotheses::Load(const CoarseDisparity& coarse) {
  const cv::Size size = coarse.disparity.size();
  map_.planes.clear();
  map_.labels.create(size, CV_16SC1);
  map_.labels.setTo(-1);
  stride_ = size.width + 2 * kPadding;
  const std::size_t padded =
      static_cast<std::size_t>(stride_) * static_cast<std::size_t>(size.height + 2 * kPadding);
  disparity_.assign(padded, std::numeric_limits<float>::quiet_NaN());
  reached_.assign(padded, 0);
  free_.Reset(stride_, size.height + 2 * kPadding);
  for (int y = 0; y < size.height; ++y) {
    const float* disparity = coarse.disparity.ptr<float>(y);
    const std::uint8_t* confident = coarse.confident.ptr<std::uint8_t>(y);
    float* row = disparity_.data() + Index(0, y);
    for (int x = 0; x < size.width; ++x) {
      if (confident[x] == 0 || !std::isfinite(disparity[x])) continue;
      row[x] = disparity[x];
      free_.Set(x + kPadding, y + kPadding);
    }
  }
}

void PlaneHypotheses::FindSeeds(ThreadPool* threads) {
  const int rows = (map_.labels.rows + kSeedStep - 1) / kSeedStep;
  seeds_of_row_.resize(static_cast<std::size_t>(rows));
  const auto find_rows = [this](int begin, int end) {
    for (int row = begin; row < end; ++row) FindSeedsOfRow(row);
  };
  if (threads != nullptr) {
    threads->ForRanges(rows, find_rows);
  } else {
    find_rows(0, rows);
  }
  seeds_.clear();
  for (const std::vector<Seed>& row : seeds_of_row_) {
    seeds_.insert(seeds_.end(), row.begin(), row.end());
  }
  std::sort(seeds_.begin(), seeds_.end(), [](const Seed& l, const Seed& r) {
    return std::tie(l.rank, l.y, l.x) < std::tie(r.rank, r.y, r.x);
  });
}

void PlaneHypotheses::FindSeedsOfRow(int row) {
  std::vector<Seed>& seeds = seeds_of_row_[static_cast<std::size_t>(row)];
  seeds.clear();
  Seed seed;
  for (int x = 0; x < map_.labels.cols; x += kSeedStep) {
    if (FitSeed(x, row * kSeedStep, &seed)) seeds.push_back(seed);
  }
}

bool PlaneHypotheses::FitSeed(int x, int y, Seed* seed) const {
  const float* centre = disparity_.data() + Index(x, y);
  if (std::isnan(*centre)) return false;
  const PlaneMoments moments = WindowMoments(centre, stride_);
  const double fill = moments.weight() / kSeedWindow;
  if (fill < kSeedFill) return false;
  const DisparityPlane local = moments.Fit();
  seed->rank = moments.Rms(local) + kMissingPenalty * (1.0 - fill);
  seed->x = x;
  seed->y = y;
  seed->plane = {local.a, local.b, local.c + *centre - local.a * x - local.b * y};
  return true;
}

void PlaneHypotheses::Grow(const Seed& seed) {
  pixels_.clear();
  moments_ = PlaneMoments();
  Take(seed.x, seed.y);
  DisparityPlane plane = seed.plane;
  double next_fit = kRefitGrowth * kSeedWindow;
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    TakeAround(static_cast<int>(pixels_[i].x), static_cast<int>(pixels_[i].y), plane);
    if (static_cast<double>(pixels_.size()) > next_fit) {
      plane = moments_.Fit();
      next_fit = kRefitGrowth * static_cast<double>(pixels_.size());
    }
  }
}

// Around most pixels of a region all are taken: whole rows are passed over by their bits.
void PlaneHypotheses::TakeAround(int x, int y, const DisparityPlane& plane) {
  const float slope = static_cast<float>(plane.a);
  for (int dy = -kGap; dy <= kGap; ++dy) {
    const unsigned free = free_.Window(x - kGap + kPadding, y + dy + kPadding);
    if (free == 0) continue;
    const float* row = disparity_.data() + Index(x, y + dy);
    const float centre = static_cast<float>(plane.At(x, y + dy));
    for (int dx = -kGap; dx <= kGap; ++dx) {
      if ((free >> (dx + kGap) & 1U) == 0) continue;
      const float residual = row[dx] - (centre + slope * static_cast<float>(dx));
      if (std::abs(residual) < kGrowRange) Take(x + dx, y + dy);
    }
  }
}

void PlaneHypotheses::Take(int x, int y) {
  const std::size_t i = static_cast<std::size_t>(Index(x, y));
  pixels_.push_back({static_cast<float>(x), static_cast<float>(y), disparity_[i]});
  moments_.Add(x, y, disparity_[i]);
  free_.Clear(x + kPadding, y + kPadding);
  reached_[i] = 1;
}

bool PlaneHypotheses::Keep(int min_area) {
  if (static_cast<int>(pixels_.size()) < min_area) return false;
  const DisparityPlane plane =
      RefitHuber(pixels_, moments_.Fit(), kHuberThreshold, kHuberIterations);
  const auto near = [&plane](const DisparitySample& s) {
    return std::abs(plane.At(s.x, s.y) - s.disparity) < kGrowRange;
  };
  const auto far = std::partition(pixels_.begin(), pixels_.end(), near);
  const int area = static_cast<int>(far - pixels_.begin());
  if (area < std::max(1, min_area)) return false;
  PlaneMoments kept;
  for (auto s = pixels_.begin(); s != far; ++s) kept.Add(s->x, s->y, s->disparity);
  if (kept.Rms(plane) > kMaxRms) return false;
  Release(far);
  const auto label = static_cast<std::int16_t>(map_.planes.size());
  for (auto s = pixels_.begin(); s != far; ++s) {
    map_.labels.at<std::int16_t>(static_cast<int>(s->y), static_cast<int>(s->x)) = label;
  }
  map_.planes.push_back({plane, area, kept.Rms(plane)});
  return true;
}

void PlaneHypotheses::Release(std::vector<DisparitySample>::const_iterator first) {
  for (auto s = first; s != pixels_.end(); ++s) {
    free_.Set(static_cast<int>(s->x) + kPadding, static_cast<int>(s->y) + kPadding);
  }
}

void PlaneHypotheses::SortByArea() {
  const std::size_t count = map_.planes.size();
  order_.resize(count);
  new_label_.resize(count);
  std::iota(order_.begin(), order_.end(), std::int16_t{0});
  const auto area = [this](std::int16_t i) {
    return map_.planes[static_cast<std::size_t>(i)].area;
  };
  std::sort(order_.begin(), order_.end(), [&area](std::int16_t l, std::int16_t r) {
    return area(l) != area(r) ? area(l) > area(r) : l < r;
  });
  sorted_.clear();
  for (const std::int16_t old_label : order_) {
    new_label_[static_cast<std::size_t>(old_label)] = static_cast<std::int16_t>(sorted_.size());
    sorted_.push_back(map_.planes[static_cast<std::size_t>(old_label)]);
  }
  std::swap(map_.planes, sorted_);
  for (int y = 0; y < map_.labels.rows; ++y) {
    std::int16_t* labels = map_.labels.ptr<std::int16_t>(y);
    for (int x = 0; x < map_.labels.cols; ++x) {
      if (labels[x] >= 0) labels[x] = new_label_[static_cast<std::size_t>(labels[x])];
    }
  }
}

}  // namespace stereo_sgmp
