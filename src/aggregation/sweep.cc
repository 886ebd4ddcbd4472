#include "aggregation/sweep.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstdlib>

namespace stereo_sgmp {
namespace {

// Slots of a workspace: two per row for the path across, one per path for moved predecessors,
// one for S.
constexpr int kTotalSlots = 1;

}  // namespace

void Sweep::Run(const SweepJob& job, ThreadPool* pool) {
  job_ = job;
  shape_ = job.costs->shape();
  Prepare(pool->size());
  pool->Run([&](int thread) { RunThread(thread, pool->size()); });
}

std::size_t Sweep::Memory(const VolumeShape& shape, int threads) {
  const int stride = shape.Stride();
  const std::size_t workspace =
      (kRowsPerGroup - 1) * StateLineBuffer::Bytes(kRing, stride) +
      (2 * kRowsPerGroup + kPathsPerSweep + kTotalSlots) * PathSlot::Size(stride) * 2 +
      static_cast<std::size_t>(kStretch) * static_cast<std::size_t>(stride) +
      kRowsPerGroup * 4 * static_cast<std::size_t>(shape.width + stride);
  return 2 * StateLineBuffer::Bytes(shape.width, stride) +
         static_cast<std::size_t>(threads) * workspace;
}

void Sweep::Prepare(int threads) {
  const int stride = shape_.Stride();
  for (StateLineBuffer& line : boundaries_)
    line.Create(shape_.width, shape_.disparities, stride, false);
  start_.Resize(PathSlot::Size(stride));
  std::fill(start_.data(), start_.data() + start_.size(), std::uint16_t{0});
  progress_.Reset(Groups());
  workspaces_.resize(static_cast<std::size_t>(threads));
  for (Workspace& workspace : workspaces_) PrepareWorkspace(&workspace);
}

void Sweep::PrepareWorkspace(Workspace* workspace) const {
  const int stride = shape_.Stride();
  const std::size_t slot = PathSlot::Size(stride);
  for (StateLineBuffer& ring : workspace->rings)
    ring.Create(kRing, shape_.disparities, stride, true);
  constexpr std::size_t kSlots = 2 * kRowsPerGroup + kPathsPerSweep + kTotalSlots;
  workspace->slots.Resize(kSlots * slot);
  FillUnreachable(workspace->slots.data(), kSlots, slot);
  workspace->cost.Resize(static_cast<std::size_t>(kStretch) * static_cast<std::size_t>(stride));
  for (RightRow& right : workspace->right) {
    const auto size = static_cast<std::size_t>(shape_.width + std::abs(shape_.min_disparity) +
                                               stride + PathSlot::kPad);
    right.cost.resize(size);
    right.winner.resize(size);
  }
}

void Sweep::RunThread(int thread, int threads) {
  Workspace& workspace = workspaces_[static_cast<std::size_t>(thread)];
  for (int group = thread; group < Groups(); group += threads) RunGroup(group, &workspace);
  // S was stored past the caches; other threads read it in the next sweep.
  hwy::FlushStream();
}

void Sweep::RunGroup(int group, Workspace* workspace) {
  const int width = shape_.width;
  const int rows = std::min(kRowsPerGroup, shape_.height - group * kRowsPerGroup);
  for (int k = 0; k < rows; ++k) StartRow(k, workspace);
  const int span = width + rows - 1;  // the last row runs rows - 1 pixels behind
  for (int begin = 0; begin < span; begin += kStretch) {
    for (int k = 0; k < rows; ++k) {
      const int u_begin = std::max(0, begin - k);
      const int u_end = std::min(width, begin + kStretch - k);
      if (u_begin >= u_end) continue;
      if (k == 0 && group > 0) progress_.WaitFor(group - 1, std::min(width, u_end + 1));
      RunStretch(group, k, rows, u_begin, u_end, workspace);
      if (k == rows - 1) progress_.Publish(group, u_end);
    }
  }
  if (job_.kind != SweepKind::kLast) return;
  for (int k = 0; k < rows; ++k) {
    FinishRow(group * kRowsPerGroup + k, workspace->right[static_cast<std::size_t>(k)]);
  }
}

void Sweep::StartRow(int row_in_group, Workspace* workspace) const {
  const auto k = static_cast<std::size_t>(row_in_group);
  const std::size_t slot = PathSlot::Size(shape_.Stride());
  AcrossState& across = workspace->across[k];
  across.before = workspace->slots.data() + 2 * k * slot + PathSlot::kPad;
  across.here = across.before + slot;
  if (job_.kind != SweepKind::kLast) return;
  RightRow& right = workspace->right[k];
  std::fill(right.cost.begin(), right.cost.end(), WinnerMap::kNone);
  std::fill(right.winner.begin(), right.winner.end(), WinnerMap::kNone);
}

void Sweep::RunStretch(int group, int row_in_group, int rows, int u_begin, int u_end,
                       Workspace* workspace) {
  const auto k = static_cast<std::size_t>(row_in_group);
  const int y = ImageRow(group * kRowsPerGroup + row_in_group);
  const int x_begin = job_.backward ? shape_.width - u_end : u_begin;
  const int x_end = x_begin + u_end - u_begin;
  const std::ptrdiff_t stride = shape_.Stride();

  SweepStretch s;
  s.u_begin = u_begin;
  s.u_end = u_end;
  s.width = shape_.width;
  s.disparities = shape_.disparities;
  s.stride = stride;
  s.x_step = job_.backward ? -1 : 1;
  s.x_first = job_.backward ? x_end - 1 : x_begin;
  s.cost =
      job_.costs->Row(y, x_begin, x_end, workspace->cost.data()) + (s.x_first - x_begin) * stride;
  const std::ptrdiff_t pixel = static_cast<std::ptrdiff_t>(y) * shape_.width + s.x_first;
  s.sum = job_.sum + pixel * stride;
  s.minimum_sum = job_.minimum_sum + pixel;

  s.has_above = group > 0 || row_in_group > 0;
  const auto parity = static_cast<std::size_t>(group % 2);
  s.above = row_in_group > 0 ? workspace->rings[k - 1].line() : boundaries_[1 - parity].line();
  s.current = row_in_group < rows - 1 ? workspace->rings[k].line() : boundaries_[parity].line();
  s.across = &workspace->across[k];

  s.p1 = job_.penalties->p1;
  s.p2 = job_.penalties->p2.data();
  for (int i = 0; i < job_.paths; ++i) {
    const auto path = static_cast<std::size_t>(i);
    const PathStep forward = kForwardSteps[path];
    // The contrast of a step is that of the opposite step from its other end.
    const PathStep end = job_.backward ? forward : PathStep{0, 0};
    s.contrast[path] = job_.contrast->Row(static_cast<Path>(i), y + end.dy) + s.x_first + end.dx;
    if (job_.prior == nullptr) continue;
    const PathStep step = job_.backward ? PathStep{-forward.dx, -forward.dy} : forward;
    job_.prior->Jumps(y, x_begin, x_end, step, &workspace->jumps[path]);
  }
  s.jumps = job_.prior != nullptr ? &workspace->jumps : nullptr;
  s.jump_slack = job_.jump_slack;
  const std::size_t slot = PathSlot::Size(shape_.Stride());
  s.moved = workspace->slots.data() + 2 * kRowsPerGroup * slot;
  s.total = s.moved + kPathsPerSweep * slot;
  s.start = start_.data() + PathSlot::kPad;
  Dispatch(s, y, &workspace->right[k]);
}

void Sweep::Dispatch(const SweepStretch& s, int y, RightRow* right) const {
  const bool four = job_.paths == kPathsPerSweep;
  switch (job_.kind) {
    case SweepKind::kFirst:
      return four ? SweepFirst<4>(s) : SweepFirst<2>(s);
    case SweepKind::kSharpen: {
      const std::ptrdiff_t pixel = static_cast<std::ptrdiff_t>(y) * shape_.width + s.x_first;
      return SweepSharpen<2>(s, job_.sharpened + pixel * s.stride);
    }
    case SweepKind::kLast: {
      WinnerMap& map = *job_.winners;
      WinnerRow row;
      row.winner = map.winner[y];
      row.cost = map.cost[y];
      row.cost_below = map.cost_below[y];
      row.cost_above = map.cost_above[y];
      row.second = map.second[y];
      row.uncertainty = map.uncertainty[y];
      row.right_cost = right->cost.data();
      row.right_winner = right->winner.data();
      row.x_origin = shape_.width - 1 + shape_.min_disparity + RightMargin();
      return four ? SweepLast<4>(s, row) : SweepLast<2>(s, row);
    }
  }
}

void Sweep::FinishRow(int v, const RightRow& right) const {
  std::uint16_t* row = job_.winners->right_winner[ImageRow(v)];
  const std::uint16_t* last = right.winner.data() + RightMargin() + shape_.width - 1;
  for (int x = 0; x < shape_.width; ++x) row[x] = *(last - x);
}

}  // namespace stereo_sgmp
