#include "refinement/plane_propagation.h"

#include <algorithm>
#include <cmath>

namespace stereo_sgmp {
namespace {

constexpr int kRounds = 2;
constexpr float kReach = 3.0f;        // a step of one pixel counts like this channel difference
constexpr float kColorScale = 40.0f;  // channel difference at which a link has fallen to 1/e
constexpr float kGateOffset = 1.5f;   // links fall from 0.2 pixels of disparity on
constexpr float kGateSlope = 2.5f;    // and end at 0.6
constexpr float kLeastWeight = 1e-6f;
constexpr float kSureConfidence = 0.9f;
constexpr float kShareSlope = 10.0f;  // the full way 0.1 below

float Clamp01(float value) { return std::min(1.0f, std::max(0.0f, value)); }

float WeightOf(float confidence) {
  const float square = confidence * confidence;
  const float fourth = square * square;
  return fourth * fourth + kLeastWeight;
}

// Weighted sums along a row, x counted from the pixel where they stand.
struct RowSums {
  float n, x, xx, e, xe;
};

RowSums SumsOfPixel(float weight, float disparity) {
  return {weight, 0.0f, 0.0f, weight * disparity, 0.0f};
}

// The sums as the right neighbour sees them, times the link to it.
RowSums ToTheRight(const RowSums& s, float link) {
  return {link * s.n, link * (s.x - s.n), link * (s.xx - 2.0f * s.x + s.n), link * s.e,
          link * (s.xe - s.e)};
}

RowSums ToTheLeft(const RowSums& s, float link) {
  return {link * s.n, link * (s.x + s.n), link * (s.xx + 2.0f * s.x + s.n), link * s.e,
          link * (s.xe + s.e)};
}

RowSums operator+(const RowSums& a, const RowSums& b) {
  return {a.n + b.n, a.x + b.x, a.xx + b.xx, a.e + b.e, a.xe + b.xe};
}

// `color_link`: of the colours of the two pixels.
float Link(float color_link, float d, float other) {
  return color_link * Clamp01(kGateOffset - kGateSlope * std::abs(d - other));
}

RowSums Pixel(const PropagationRow& row, int x) {
  return SumsOfPixel(row.weight[x], row.disparity[x]);
}

RowSums Load(const PropagationRow& row, int x) {
  return {row.sums[0][x], row.sums[1][x], row.sums[2][x], row.sums[3][x], row.sums[4][x]};
}

void Store(const RowSums& s, const PropagationRow& row, int x) {
  row.sums[0][x] = s.n;
  row.sums[1][x] = s.x;
  row.sums[2][x] = s.xx;
  row.sums[3][x] = s.e;
  row.sums[4][x] = s.xe;
}

// First the sums over the pixels up to each one, then those over what lies to its right.
template <int kRows>
void SumAlong(const std::array<PropagationRow, kRows>& rows, const float* color_link, int width,
              std::ptrdiff_t stride) {
  std::array<RowSums, kRows> sums;
  for (std::size_t i = 0; i < kRows; ++i) {
    sums[i] = Pixel(rows[i], 0);
    Store(sums[i], rows[i], 0);
  }
  for (int x = 1; x < width; ++x) {
    for (std::size_t i = 0; i < kRows; ++i) {
      const PropagationRow& row = rows[i];
      const float link =
          Link(color_link[row.difference[x]], row.disparity[x], row.disparity[x - 1]);
      sums[i] = Pixel(row, x) + ToTheRight(sums[i], link);
      Store(sums[i], row, x);
    }
  }
  for (std::size_t i = 0; i < kRows; ++i) {
    for (int x = width; x < stride; ++x) Store(Pixel(rows[i], x), rows[i], x);
    sums[i] = Pixel(rows[i], width - 1);
  }
  for (int x = width - 2; x >= 0; --x) {
    for (std::size_t i = 0; i < kRows; ++i) {
      const PropagationRow& row = rows[i];
      const float link =
          Link(color_link[row.difference[x + 1]], row.disparity[x + 1], row.disparity[x]);
      const RowSums beyond = ToTheLeft(sums[i], link);
      sums[i] = Pixel(row, x) + beyond;
      Store(Load(row, x) + beyond, row, x);
    }
  }
}

}  // namespace

PlanePropagation::PlanePropagation() {
  for (std::size_t i = 0; i < color_link_.size(); ++i) {
    color_link_[i] = std::exp(-(kReach + static_cast<float>(i)) / kColorScale);
  }
}

void PlanePropagation::Apply(const cv::Mat& image, const cv::Mat& confidence, cv::Mat* disparity,
                             ThreadPool* pool) {
  const cv::Size size = disparity->size();
  Reserve(size, pool->size());
  contrast_.Compute(image, pool);
  pool->ForRanges(size.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) LoadRow(confidence, *disparity, y);
  });
  const int strips = static_cast<int>(stride_ / PropagationStrip::kWidth);
  for (int round = 0; round < kRounds; ++round) {
    pool->ForRanges(size.height, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) LinkDown(size.width, y);
      SumAlongRows(size.width, begin, end);
    });
    pool->ForPieces(strips, 1, [&](int thread, int strip, int) {
      MoveToPlanes(strip, size.height, scratch_[static_cast<std::size_t>(thread)].data());
    });
  }
  pool->ForRanges(size.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      std::copy_n(disparity_.data() + Offset(y), size.width, disparity->ptr<float>(y));
    }
  });
}

void PlanePropagation::Reserve(cv::Size size, int threads) {
  constexpr std::ptrdiff_t kWidth = PropagationStrip::kWidth;
  stride_ = (size.width + kWidth - 1) / kWidth * kWidth;
  const std::size_t pixels =
      static_cast<std::size_t>(stride_) * static_cast<std::size_t>(size.height);
  for (auto* buffer : {&disparity_, &weight_, &share_, &down_}) buffer->Resize(pixels);
  for (auto& buffer : sums_) buffer.Resize(pixels);
  scratch_.resize(static_cast<std::size_t>(threads));
  for (auto& buffer : scratch_) buffer.Resize(PropagationStrip::ScratchSize(size.height));
}

// The columns beyond the image, up to a whole strip, become sure pixels of disparity 0.
void PlanePropagation::LoadRow(const cv::Mat& confidence, const cv::Mat& disparity, int y) {
  const float* c = confidence.ptr<float>(y);
  float* d = disparity_.data() + Offset(y);
  float* weight = weight_.data() + Offset(y);
  float* share = share_.data() + Offset(y);
  std::copy_n(disparity.ptr<float>(y), disparity.cols, d);
  for (int x = 0; x < disparity.cols; ++x) {
    weight[x] = WeightOf(c[x]);
    share[x] = Clamp01(kShareSlope * (kSureConfidence - c[x]));
  }
  std::fill(d + disparity.cols, d + stride_, 0.0f);
  std::fill(weight + disparity.cols, weight + stride_, 1.0f);
  std::fill(share + disparity.cols, share + stride_, 0.0f);
}

void PlanePropagation::LinkDown(int width, int y) {
  float* link = down_.data() + Offset(y);
  std::fill(link, link + stride_, 0.0f);
  if (y == 0) return;
  const float* d = disparity_.data() + Offset(y);
  const std::uint8_t* difference = contrast_.Row(kDown, y);
  for (int x = 0; x < width; ++x) link[x] = Link(color_link_[difference[x]], d[x], d[x - stride_]);
}

void PlanePropagation::SumAlongRows(int width, int begin, int end) {
  // Two rows side by side, since each sum waits for the one before it.
  int y = begin;
  for (; y + 1 < end; y += 2) {
    SumAlong<2>({RowAt(y), RowAt(y + 1)}, color_link_.data(), width, stride_);
  }
  if (y < end) SumAlong<1>({RowAt(y)}, color_link_.data(), width, stride_);
}

PropagationRow PlanePropagation::RowAt(int y) {
  PropagationRow row;
  row.disparity = disparity_.data() + Offset(y);
  row.weight = weight_.data() + Offset(y);
  row.difference = contrast_.Row(kAcross, y);
  for (std::size_t i = 0; i < sums_.size(); ++i) row.sums[i] = sums_[i].data() + Offset(y);
  return row;
}

void PlanePropagation::MoveToPlanes(int strip, int height, float* scratch) {
  const std::ptrdiff_t x = static_cast<std::ptrdiff_t>(strip) * PropagationStrip::kWidth;
  PropagationStrip columns;
  columns.height = height;
  columns.stride = stride_;
  for (std::size_t i = 0; i < sums_.size(); ++i) columns.sums[i] = sums_[i].data() + x;
  columns.down = down_.data() + x;
  columns.share = share_.data() + x;
  columns.disparity = disparity_.data() + x;
  columns.scratch = scratch;
  PropagateDownColumns(columns);
}

}  // namespace stereo_sgmp
