#include "prior/plane_hypotheses.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "prior/plane_seed_kernel.h"
#include "prior/plane_sets.h"

namespace stereo_sgmp {
namespace {

constexpr int kSeedWindow = (2 * kSeedRadius + 1) * (2 * kSeedRadius + 1);
// Seeds that are put in order at once: these, or this share of all that are left.
constexpr std::size_t kSeedsInOrder = 256;
constexpr std::size_t kSeedShare = 4;
// Residuals that fill the range around the plane evenly have a root mean square of 0.35: near that
// the region is no plane but whatever the range happened to cut out.
constexpr double kMaxRms = 0.3;
// The plane is fitted again each time its region has become this much larger.
constexpr double kRefitGrowth = 1.5;
// Final fit: residuals beyond this count less, coarse disparities.
constexpr double kHuberThreshold = 0.5;
constexpr int kHuberIterations = 2;

constexpr int kPadding = std::max(kSeedRadius + 1, kGapOverrun);

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

}  // namespace

int SmallestPlane(const PriorOptions& options, cv::Size size) {
  return std::min(options.min_plane_area, std::max(1, size.area() / 50));
}

void PlaneHypotheses::Find(const CoarseDisparity& coarse, int min_area, ThreadPool* threads) {
  CheckInputs(coarse);
  Load(coarse);
  FindSeeds(threads);
  GrowFromSeeds(min_area);
  SortByArea();
}

// The best first. Most seeds are reached before it is their turn, so that only those that come next
// are put in order.
void PlaneHypotheses::GrowFromSeeds(int min_area) {
  const auto before = [](const Seed& l, const Seed& r) {
    return std::tie(l.rank, l.y, l.x) < std::tie(r.rank, r.y, r.x);
  };
  const auto is_reached = [this](const Seed& seed) {
    return reached_[static_cast<std::size_t>(Index(seed.x, seed.y))] != 0;
  };
  auto next = seeds_.begin();
  auto end = seeds_.end();
  while (next != end) {
    const auto left = static_cast<std::size_t>(end - next);
    const std::size_t count = std::min(left, std::max(kSeedsInOrder, left / kSeedShare));
    const auto ordered = next + static_cast<std::ptrdiff_t>(count);
    if (ordered != end) std::nth_element(next, ordered, end, before);
    std::sort(next, ordered, before);
    for (; next != ordered; ++next) {
      if (map_.planes.size() >= PlaneSet::kMaxListed) return;
      if (is_reached(*next)) continue;
      Grow(*next);
      if (!Keep(min_area)) Release(region_.pixels);
    }
    end = std::remove_if(next, end, is_reached);
  }
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
  disparity_.assign(padded + kSeedOverrun, std::numeric_limits<float>::quiet_NaN());
  reached_.assign(padded, 0);
  pixels_.Resize(static_cast<std::size_t>(size.area()));
  for (int y = 0; y < size.height; ++y) {
    const float* disparity = coarse.disparity.ptr<float>(y);
    const std::uint8_t* confident = coarse.confident.ptr<std::uint8_t>(y);
    float* row = disparity_.data() + Index(0, y);
    for (int x = 0; x < size.width; ++x) {
      if (confident[x] != 0 && std::isfinite(disparity[x])) row[x] = disparity[x];
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
}

void PlaneHypotheses::FindSeedsOfRow(int row) {
  std::vector<Seed>& seeds = seeds_of_row_[static_cast<std::size_t>(row)];
  seeds.clear();
  const int y = row * kSeedStep;
  const int width = map_.labels.cols;
  SeedBatch batch;
  for (int begin = 0; begin < width; begin += kSeedStep * kSeedBatch) {
    const float* centre = disparity_.data() + Index(begin, y);
    FitSeeds(centre, stride_, &batch);
    for (std::size_t i = 0; i < kSeedBatch; ++i, centre += kSeedStep) {
      const int x = begin + static_cast<int>(i) * kSeedStep;
      if (x >= width || std::isinf(batch.rank[i])) continue;
      const double c = batch.c[i] + *centre - batch.a[i] * x - batch.b[i] * y;
      seeds.push_back({batch.rank[i], x, y, {batch.a[i], batch.b[i], c}});
    }
  }
}

void PlaneHypotheses::Grow(const Seed& seed) {
  const auto origin = static_cast<std::size_t>(Index(0, 0));
  region_ = {&disparity_[origin], &reached_[origin], stride_, pixels_.data(), 0};
  moments_ = PlaneMoments();
  summed_ = 0;
  TakePixel(seed.x, seed.y, &region_);
  DisparityPlane plane = seed.plane;
  double next_fit = kRefitGrowth * kSeedWindow;
  for (std::size_t next = 0; next < region_.count;) {
    next = GrowRegion(plane, next, next_fit, &region_);
    plane = Moments().Fit();
    next_fit = kRefitGrowth * static_cast<double>(region_.count);
  }
}

// Of the region so far.
const PlaneMoments& PlaneHypotheses::Moments() {
  PlaneMoments moments = moments_;  // in registers
  for (; summed_ < region_.count; ++summed_) {
    const DisparitySample& s = pixels_[summed_];
    moments.Add(s.x, s.y, s.disparity);
  }
  return moments_ = moments;
}

bool PlaneHypotheses::Keep(int min_area) {
  if (static_cast<int>(region_.count) < min_area) return false;
  DisparitySample* const first = region_.pixels;
  DisparitySample* const last = first + region_.count;
  const DisparityPlane plane =
      RefitHuber(first, region_.count, moments_.Fit(), kHuberThreshold, kHuberIterations);
  const auto near = [&plane](const DisparitySample& s) {
    return std::abs(plane.At(s.x, s.y) - s.disparity) < kGrowRange;
  };
  DisparitySample* const far = std::partition(first, last, near);
  const int area = static_cast<int>(far - first);
  if (area < std::max(1, min_area)) return false;
  PlaneMoments kept;
  for (const DisparitySample* s = first; s != far; ++s) kept.Add(s->x, s->y, s->disparity);
  if (kept.Rms(plane) > kMaxRms) return false;
  Release(far);
  const auto label = static_cast<std::int16_t>(map_.planes.size());
  for (const DisparitySample* s = first; s != far; ++s) {
    map_.labels.at<std::int16_t>(static_cast<int>(s->y), static_cast<int>(s->x)) = label;
  }
  map_.planes.push_back({plane, area, kept.Rms(plane)});
  return true;
}

// Gives the pixels of the region from `first` on back to the image.
void PlaneHypotheses::Release(const DisparitySample* first) {
  const DisparitySample* const last = region_.pixels + region_.count;
  for (const DisparitySample* s = first; s != last; ++s) {
    const int index = Index(static_cast<int>(s->x), static_cast<int>(s->y));
    disparity_[static_cast<std::size_t>(index)] = s->disparity;
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
