#include "aggregation/sweep.h"

#include <algorithm>
#include <limits>

#include "cost/match_span.h"

namespace stereo_sgmp {
namespace {

constexpr int kRing = 32;       // power of two, >= SweepStretch::kMaxPixels + 3
constexpr int kRightParts = 3;  // RightRow: S, and an index of two parts
// Two for each row, for the path across, and one for messages on their way.
constexpr std::size_t kSlots = 2 * SweepWorkspace<std::uint8_t>::kRows + 1;

}  // namespace

template <class T>
std::size_t SweepWorkspace<T>::Bytes(const VolumeShape& shape) {
  const int stride = shape.Stride();
  const auto padded = static_cast<std::size_t>(stride);
  return (kRows - 1) * StateLineBuffer<T>::Bytes(kRing, stride) +
         kSlots * PathSlot<T>::Size(stride) * sizeof(T) + (1 + sizeof(T)) * kStretch * padded +
         kRows * kRightParts * sizeof(T) * padded;
}

template <class T>
void SweepWorkspace<T>::Prepare(const VolumeShape& shape) {
  const int stride = shape.Stride();
  const auto padded = static_cast<std::size_t>(stride);
  for (StateLineBuffer<T>& ring : rings) ring.Create(kRing, shape.disparities, stride, true);
  slots.Resize(kSlots * PathSlot<T>::Size(stride));
  std::fill_n(slots.data(), slots.size(), PathSlot<T>::kUnreachable);
  cost.Resize(kStretch * padded);
  excess.Resize(kStretch * padded);
  for (AlignedBuffer<T>& row : right) row.Resize(kRightParts * padded);
}

template <class T>
std::size_t Sweep<T>::Memory(const VolumeShape& shape) {
  const int stride = shape.Stride();
  return StateLineBuffer<T>::Bytes(shape.width, stride) + StateLineBuffer<T>::Bytes(1, stride);
}

template <class T>
void Sweep<T>::Start(const SweepJob<T>& job, StateLineBuffer<T>* before,
                     StateLineBuffer<T>* after) {
  job_ = job;
  before_ = before;
  after_ = after;
  shape_ = job.costs->shape();
  const int stride = shape_.Stride();
  boundary_.Create(shape_.width, shape_.disparities, stride, false);
  before_has_moved_ = before != nullptr && before->has_moved();
  if (before != nullptr && job.prior != nullptr) before->SetMoved();
  if (after != nullptr) after->Create(shape_.width, shape_.disparities, stride, false);
  start_.Create(1, shape_.disparities, stride, true);
  for (std::size_t i = 0; i < p2_.size(); ++i) p2_[i] = static_cast<T>(job.penalties->p2[i]);
  groups_.resize(static_cast<std::size_t>(Rows()));
  group_count_ = 0;
  next_row_ = 0;
  progress_.Reset(Rows());
}

template <class T>
int Sweep<T>::AddGroup(int rows, SweepKind kind) {
  groups_[static_cast<std::size_t>(group_count_)] = {next_row_, rows, kind};
  next_row_ += rows;
  return group_count_++;
}

template <class T>
typename Sweep<T>::RowPlace Sweep<T>::PlaceOf(int group, int row) const {
  const Group& g = groups_[static_cast<std::size_t>(group)];
  const int v = g.begin + row;
  return {group, row, g.rows, backward_ ? job_.end - 1 - v : job_.begin + v, g.kind};
}

template <class T>
void Sweep<T>::RunGroup(int group, Workspace* workspace) {
  const int rows = groups_[static_cast<std::size_t>(group)].rows;
  for (int row = 0; row < rows; ++row) StartRow(PlaceOf(group, row), workspace);
  const int width = shape_.width;
  const int span = width + rows - 1;  // the last row runs rows - 1 pixels behind
  for (int begin = 0; begin < span; begin += Workspace::kStretch) {
    for (int row = 0; row < rows; ++row) {
      const int u_begin = std::max(0, begin - row);
      const int u_end = std::min(width, begin + Workspace::kStretch - row);
      if (u_begin >= u_end) continue;
      if (row == 0 && group > 0) progress_.WaitFor(group - 1, std::min(width, u_end + 1));
      const RowPlace place = PlaceOf(group, row);
      if (job_.prior != nullptr && begin % Workspace::kJumpSpan == 0) {
        AskPrior(place, u_begin, std::min(width, begin + Workspace::kJumpSpan - row),
                 &workspace->jumps[static_cast<std::size_t>(row)]);
      }
      RunStretch(place, u_begin, u_end, workspace);
      if (u_end == width) EndRow(place, workspace);
      if (place.IsLast()) progress_.Publish(group, u_end);
    }
  }
}

template <class T>
void Sweep<T>::StartRow(const RowPlace& place, Workspace* workspace) const {
  const auto k = static_cast<std::size_t>(place.row);
  const std::size_t slot = PathSlot<T>::Size(shape_.Stride());
  if (!place.IsLast()) workspace->rings[k].SetStart(-1);
  AcrossState<T>& across = workspace->across[k];
  across.before = workspace->slots.data() + 2 * k * slot + PathSlot<T>::kPad;
  across.here = across.before + slot;
  std::fill_n(across.before, shape_.disparities, T{0});  // paths start there
  SweepStretch<T>& s = workspace->stretches[k];
  s = SweepStretch<T>();
  s.kind = place.kind;
  s.paths = job_.paths;
  s.width = shape_.width;
  s.all_disparities = shape_.disparities;
  s.stride = shape_.Stride();
  s.x_step = backward_ ? -1 : 1;
  for (int i = 0; i < job_.paths; ++i) {
    const auto path = static_cast<std::size_t>(i);
    // The contrast of a step is that of the opposite step from its other end.
    const PathStep end = backward_ ? kForwardSteps[path] : PathStep{0, 0};
    s.contrast[path] = job_.contrast->Row(static_cast<Path>(i), place.y + end.dy) + end.dx;
  }
  s.has_above = !IsFirstOfImage(place);
  s.above_has_moved = IsFirstOfJob(place) && before_has_moved_;
  s.above = Above(place, *workspace);
  s.current = Current(place, *workspace);
  s.across = &across;
  s.p1 = static_cast<T>(job_.penalties->p1);
  s.p2 = p2_.data();
  s.excess = workspace->excess.data();
  s.unit = static_cast<std::uint16_t>(job_.costs->unit());
  if (job_.prior != nullptr) {
    s.jumps = &workspace->jumps[k].rows;
    s.moves = workspace->jumps[k].moves.data();
    const int slack = job_.penalties->slack;
    if (slack >= 0) s.price_of_staying = static_cast<T>(slack);
    s.moved = workspace->slots.data() + 2 * Workspace::kRows * slot;
  }
  if (place.kind == SweepKind::kLast) StartWinners(place.y, &workspace->right[k], &s);
}

template <class T>
void Sweep<T>::EndRow(const RowPlace& place, Workspace* workspace) const {
  if (place.IsLast()) return;
  workspace->rings[static_cast<std::size_t>(place.row)].SetStart(shape_.width);
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
  if (IsFirstOfImage(place)) return start_.line();
  if (place.row > 0) return workspace.rings[static_cast<std::size_t>(place.row) - 1].line();
  if (place.group > 0) return boundary_.line();
  return before_->line();
}

template <class T>
StateLine<T> Sweep<T>::Current(const RowPlace& place, const Workspace& workspace) const {
  if (!place.IsLast()) return workspace.rings[static_cast<std::size_t>(place.row)].line();
  const bool ends_job = place.y == (backward_ ? job_.begin : job_.end - 1);
  if (after_ != nullptr && ends_job) return after_->line();
  // Behind what the first row of the group still reads of it.
  return boundary_.line();
}

// In parts whose pixels reach the same disparities.
template <class T>
void Sweep<T>::RunStretch(const RowPlace& place, int u_begin, int u_end,
                          Workspace* workspace) const {
  while (u_begin < u_end) {
    const MatchSpan columns = ColumnsOfSameReach(shape_, ImageColumn(u_begin, u_begin + 1));
    const int u_next = std::min(u_end, backward_ ? shape_.width - columns.begin : columns.end);
    RunPart(place, u_begin, u_next, workspace);
    u_begin = u_next;
  }
}

template <class T>
void Sweep<T>::RunPart(const RowPlace& place, int u_begin, int u_end, Workspace* workspace) const {
  const int y = place.y;
  const int x_begin = ImageColumn(u_begin, u_end);
  const int x_end = x_begin + u_end - u_begin;
  SweepStretch<T>& s = workspace->stretches[static_cast<std::size_t>(place.row)];
  s.u_begin = u_begin;
  s.u_end = u_end;
  s.disparities = ReachedDisparities(shape_, x_begin);
  const int x_first = backward_ ? x_end - 1 : x_begin;
  for (int i = 0; i < job_.paths; ++i) {
    s.contrast[static_cast<std::size_t>(i)] += x_first - s.x_first;
  }
  s.x_first = x_first;
  const std::uint8_t* costs = job_.costs->Row(y, x_begin, x_end, workspace->cost.data());
  s.cost = costs + (s.x_first - x_begin) * s.stride;
  s.has_stored_costs = costs != workspace->cost.data();
  const int first_jump_column = workspace->jumps[static_cast<std::size_t>(place.row)].x_begin;
  s.first_jump = s.x_first - first_jump_column;
  PlaceSums(place, &s);
  SweepPixels(s);
}

template <class T>
void Sweep<T>::AskPrior(const RowPlace& place, int u_begin, int u_end,
                        typename Workspace::JumpSpan* span) const {
  span->x_begin = ImageColumn(u_begin, u_end);
  const int x_end = span->x_begin + u_end - u_begin;
  span->moves.fill(0);
  std::array<PathStep, kPathsPerSweep> steps = kForwardSteps;
  if (backward_) {
    for (PathStep& step : steps) step = {-step.dx, -step.dy};
  }
  const int y = place.y;
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
void Sweep<T>::PlaceSums(const RowPlace& place, SweepStretch<T>* stretch) const {
  if (place.kind == SweepKind::kStates) return;
  const std::ptrdiff_t pixel =
      static_cast<std::ptrdiff_t>(place.y) * shape_.width + stretch->x_first;
  const std::ptrdiff_t last = static_cast<std::ptrdiff_t>(job_.end) * shape_.width - 1;
  stretch->sum = job_.sum + (last - pixel) * stretch->stride;
  stretch->minimum_sum = job_.minimum_sum + pixel;
  if (place.kind == SweepKind::kSharpen) {
    stretch->sharpened = job_.sharpened + pixel * stretch->stride;
  }
}

template struct SweepWorkspace<std::uint8_t>;
template struct SweepWorkspace<std::uint16_t>;
template class Sweep<std::uint8_t>;
template class Sweep<std::uint16_t>;

}  // namespace stereo_sgmp
