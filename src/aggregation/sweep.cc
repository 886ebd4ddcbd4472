#include "aggregation/sweep.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <limits>

#include "cost/match_span.h"

namespace stereo_sgmp {

template <class T>
void Sweep<T>::Run(const SweepJob<T>& job, const StateLineBuffer<T>* before,
                   StateLineBuffer<T>* after, ThreadPool* pool) {
  job_ = job;
  before_ = before;
  after_ = after;
  shape_ = job.costs->shape();
  Prepare(pool->size());
  pool->Run([&](int thread) { RunThread(thread, pool->size()); });
}

template <class T>
std::size_t Sweep<T>::Memory(const VolumeShape& shape, int threads) {
  const int stride = shape.Stride();
  constexpr std::size_t kSlots = 2 * kRowsPerGroup + kPathsPerSweep;
  const std::size_t workspace =
      (kRowsPerGroup - 1) * StateLineBuffer<T>::Bytes(kRing, stride) +
      kSlots * PathSlot<T>::Size(stride) * sizeof(T) +
      (1 + sizeof(T)) * static_cast<std::size_t>(kStretch) * static_cast<std::size_t>(stride) +
      kRowsPerGroup * kRightParts * sizeof(T) * static_cast<std::size_t>(stride);
  return 2 * StateLineBuffer<T>::Bytes(shape.width, stride) +
         static_cast<std::size_t>(threads) * workspace;
}

template <class T>
void Sweep<T>::Prepare(int threads) {
  const int stride = shape_.Stride();
  for (StateLineBuffer<T>& line : boundaries_) {
    line.Create(shape_.width, shape_.disparities, stride, false);
  }
  if (after_ != nullptr) after_->Create(shape_.width, shape_.disparities, stride, false);
  start_.Resize(PathSlot<T>::Size(stride));
  std::fill_n(start_.data(), start_.size(), T{0});
  for (std::size_t i = 0; i < p2_.size(); ++i) p2_[i] = static_cast<T>(job_.penalties->p2[i]);
  progress_.Reset(Groups());
  workspaces_.resize(static_cast<std::size_t>(threads));
  for (Workspace& workspace : workspaces_) PrepareWorkspace(&workspace);
}

// Slots of a workspace: two per row for the path across, one per path for messages that moved.
template <class T>
void Sweep<T>::PrepareWorkspace(Workspace* workspace) const {
  const int stride = shape_.Stride();
  const auto padded = static_cast<std::size_t>(stride);
  for (StateLineBuffer<T>& ring : workspace->rings) {
    ring.Create(kRing, shape_.disparities, stride, true);
  }
  workspace->slots.Resize((2 * kRowsPerGroup + kPathsPerSweep) * PathSlot<T>::Size(stride));
  std::fill_n(workspace->slots.data(), workspace->slots.size(), PathSlot<T>::kUnreachable);
  workspace->cost.Resize(kStretch * padded);
  workspace->excess.Resize(kStretch * padded);
  for (AlignedBuffer<T>& right : workspace->right) right.Resize(kRightParts * padded);
}

template <class T>
void Sweep<T>::RunThread(int thread, int threads) {
  Workspace& workspace = workspaces_[static_cast<std::size_t>(thread)];
  for (int group = thread; group < Groups(); group += threads) RunGroup(group, &workspace);
  // S was stored past the caches; other threads read it in the next sweep.
  hwy::FlushStream();
}

template <class T>
void Sweep<T>::RunGroup(int group, Workspace* workspace) {
  const int width = shape_.width;
  RowPlace place;
  place.group = group;
  const int first = job_.begin + group * kRowsPerGroup;
  place.rows = std::min(kRowsPerGroup, job_.end - first);
  for (place.row = 0; place.row < place.rows; ++place.row) {
    place.v = first + place.row;
    StartRow(place, workspace);
  }
  const int span = width + place.rows - 1;  // the last row runs rows - 1 pixels behind
  for (int begin = 0; begin < span; begin += kStretch) {
    for (int row = 0; row < place.rows; ++row) {
      const int u_begin = std::max(0, begin - row);
      const int u_end = std::min(width, begin + kStretch - row);
      if (u_begin >= u_end) continue;
      if (row == 0 && group > 0) progress_.WaitFor(group - 1, std::min(width, u_end + 1));
      place.row = row;
      place.v = first + row;
      if (job_.prior != nullptr && begin % kJumpSpan == 0) {
        AskPrior(place, u_begin, std::min(width, begin + kJumpSpan - row),
                 &workspace->jumps[static_cast<std::size_t>(row)]);
      }
      RunStretch(place, u_begin, u_end, workspace);
      if (place.IsLast()) progress_.Publish(group, u_end);
    }
  }
}

template <class T>
void Sweep<T>::StartRow(const RowPlace& place, Workspace* workspace) const {
  const auto k = static_cast<std::size_t>(place.row);
  const int y = ImageRow(place.v);
  const std::size_t slot = PathSlot<T>::Size(shape_.Stride());
  AcrossState<T>& across = workspace->across[k];
  across.before = workspace->slots.data() + 2 * k * slot + PathSlot<T>::kPad;
  across.here = across.before + slot;
  SweepStretch<T>& s = workspace->stretches[k];
  s = SweepStretch<T>();
  s.kind = job_.kind;
  s.paths = job_.paths;
  s.width = shape_.width;
  s.all_disparities = shape_.disparities;
  s.stride = shape_.Stride();
  s.x_step = job_.backward ? -1 : 1;
  s.has_above = place.v > 0;
  s.above = Above(place, *workspace);
  s.current = Current(place, *workspace);
  s.across = &across;
  s.p1 = static_cast<T>(job_.penalties->p1);
  s.p2 = p2_.data();
  s.start = start_.data() + PathSlot<T>::kPad;
  s.excess = workspace->excess.data();
  s.unit = static_cast<std::uint16_t>(job_.costs->unit());
  if (job_.prior != nullptr) {
    s.jumps = &workspace->jumps[k].rows;
    s.moves = workspace->jumps[k].moves.data();
    s.jump_slack = job_.penalties->slack;
    s.moved = workspace->slots.data() + 2 * kRowsPerGroup * slot;
  }
  if (job_.kind == SweepKind::kLast) StartWinners(y, &workspace->right[k], &s);
}

template <class T>
void Sweep<T>::StartWinners(int y, AlignedBuffer<T>* right, SweepStretch<T>* stretch) const {
  WinnerMap& map = *job_.winners;
  std::fill_n(right->data(), right->size(), std::numeric_limits<T>::max());
  std::fill_n(map.right_winner[y], shape_.width, WinnerMap::kNone);
  stretch->winners = {map.winner[y],     map.cost[y],   map.cost_below[y],
                      map.cost_above[y], map.second[y], map.uncertainty[y]};
  stretch->right = {right->data(), right->data() + stretch->stride, map.right_winner[y],
                    shape_.min_disparity};
}

template <class T>
StateLine<T> Sweep<T>::Above(const RowPlace& place, const Workspace& workspace) const {
  if (place.row > 0) return workspace.rings[static_cast<std::size_t>(place.row) - 1].line();
  if (place.group > 0) return boundaries_[static_cast<std::size_t>(1 - place.group % 2)].line();
  return before_ != nullptr ? before_->line() : StateLine<T>();
}

template <class T>
StateLine<T> Sweep<T>::Current(const RowPlace& place, const Workspace& workspace) const {
  if (!place.IsLast()) return workspace.rings[static_cast<std::size_t>(place.row)].line();
  if (after_ != nullptr && place.group == Groups() - 1) return after_->line();
  return boundaries_[static_cast<std::size_t>(place.group % 2)].line();
}

// In parts whose pixels reach the same disparities.
template <class T>
void Sweep<T>::RunStretch(const RowPlace& place, int u_begin, int u_end, Workspace* workspace) {
  while (u_begin < u_end) {
    const MatchSpan columns = ColumnsOfSameReach(shape_, ImageColumn(u_begin, u_begin + 1));
    const int u_next = std::min(u_end, job_.backward ? shape_.width - columns.begin : columns.end);
    RunPart(place, u_begin, u_next, workspace);
    u_begin = u_next;
  }
}

template <class T>
void Sweep<T>::RunPart(const RowPlace& place, int u_begin, int u_end, Workspace* workspace) {
  const int y = ImageRow(place.v);
  const int x_begin = ImageColumn(u_begin, u_end);
  const int x_end = x_begin + u_end - u_begin;
  SweepStretch<T>& s = workspace->stretches[static_cast<std::size_t>(place.row)];
  s.u_begin = u_begin;
  s.u_end = u_end;
  s.disparities = ReachedDisparities(shape_, x_begin);
  s.x_first = job_.backward ? x_end - 1 : x_begin;
  const std::uint8_t* costs = job_.costs->Row(y, x_begin, x_end, workspace->cost.data());
  s.cost = costs + (s.x_first - x_begin) * s.stride;
  s.has_stored_costs = costs != workspace->cost.data();
  for (int i = 0; i < job_.paths; ++i) {
    const auto path = static_cast<std::size_t>(i);
    // The contrast of a step is that of the opposite step from its other end.
    const PathStep end = job_.backward ? kForwardSteps[path] : PathStep{0, 0};
    s.contrast[path] = job_.contrast->Row(static_cast<Path>(i), y + end.dy) + s.x_first + end.dx;
  }
  const int first_jump_column = workspace->jumps[static_cast<std::size_t>(place.row)].x_begin;
  s.first_jump = s.x_first - first_jump_column;
  PlaceSums(y, &s);
  SweepPixels(s);
}

template <class T>
void Sweep<T>::AskPrior(const RowPlace& place, int u_begin, int u_end, JumpSpan* span) const {
  span->x_begin = ImageColumn(u_begin, u_end);
  const int x_end = span->x_begin + u_end - u_begin;
  span->moves.fill(0);
  std::array<PathStep, kPathsPerSweep> steps = kForwardSteps;
  if (job_.backward) {
    for (PathStep& step : steps) step = {-step.dx, -step.dy};
  }
  const int y = ImageRow(place.v);
  job_.prior->Jumps(y, span->x_begin, x_end, steps[kAcross], &span->rows[kAcross]);
  job_.prior->JumpsOfSteps(y, span->x_begin, x_end, &steps[kDown], job_.paths - kDown,
                           &span->rows[kDown]);
  for (int i = 0; i < job_.paths; ++i) {
    const std::int16_t* jumps = span->rows[static_cast<std::size_t>(i)].jump.data();
    for (std::size_t entry = 0; entry < static_cast<std::size_t>(u_end - u_begin); ++entry) {
      const int moves = jumps[entry] != 0 ? 1 << i : 0;
      span->moves[entry] = static_cast<std::uint8_t>(span->moves[entry] | moves);
    }
  }
}

template <class T>
void Sweep<T>::PlaceSums(int y, SweepStretch<T>* stretch) const {
  if (job_.kind == SweepKind::kStates) return;
  const std::ptrdiff_t pixel = static_cast<std::ptrdiff_t>(y) * shape_.width + stretch->x_first;
  const std::ptrdiff_t last = static_cast<std::ptrdiff_t>(job_.sum_rows_end) * shape_.width - 1;
  stretch->sum = job_.sum + (last - pixel) * stretch->stride;
  stretch->minimum_sum = job_.minimum_sum + pixel;
  if (job_.kind == SweepKind::kSharpen) {
    stretch->sharpened = job_.sharpened + pixel * stretch->stride;
  }
}

template class Sweep<std::uint8_t>;
template class Sweep<std::uint16_t>;

}  // namespace stereo_sgmp
