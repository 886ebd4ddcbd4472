#include "prior/plane_set_prior.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

#include <hwy/base.h>

#include "prior/phased_plane_kernel.h"
#include "prior/plane_columns.h"
#include "prior/plane_jump_kernel.h"
#include "prior/segment_writer.h"

namespace stereo_sgmp {
namespace {

// Which of `cells` cells along `pixels` pixels holds the centre of pixel i.
int CellOf(int i, int pixels, int cells) {
  return static_cast<int>((2 * std::int64_t{i} + 1) * cells / (2 * std::int64_t{pixels}));
}

void CheckSets(const std::vector<DisparityPlane>& planes, const PlaneSets& sets) {
  if (sets.ids.empty() || sets.ids.type() != CV_16UC1 || sets.sets.empty()) {
    throw std::invalid_argument(
        "A plane set prior needs at least the empty set and a CV_16U image of set numbers.");
  }
  for (const DisparityPlane& plane : planes) {
    if (FixedPlane::Holds(plane)) continue;
    throw std::invalid_argument("The plane d = " + std::to_string(plane.a) + " x + " +
                                std::to_string(plane.b) + " y + " + std::to_string(plane.c) +
                                " is too steep or not finite; expected slopes within +-" +
                                std::to_string(FixedPlane::kMaxSlope) + ".");
  }
}

std::size_t At(int i) { return static_cast<std::size_t>(i); }

// Numbers the steps to the neighbours of a pixel.
std::size_t SlotOf(PathStep step) { return At((step.dy + 1) * 3 + step.dx + 1); }

// The lowest bit that is set; there has to be one.
int FirstOf(std::uint64_t bits) {
  return static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(bits));
}

// The bits from `begin` to `end`, as far as they are among the lowest `count`, up to 64.
std::uint64_t BitsFrom(int begin, int end, int count) {
  begin = std::clamp(begin, 0, count);
  end = std::clamp(end, begin, count);
  if (begin == end) return 0;
  return (~std::uint64_t{0} >> (64 - (end - begin))) << begin;
}

// Writes what one step does to the entries of its row. `entry` is that of the run's first pixel.
void WriteMoves(const PlaneRuns& runs, const PlaneMoves& moves, int step, int entry, JumpRow* row) {
  const std::size_t s = At(step);
  for (std::uint64_t alike = moves.alike[s]; alike != 0; alike &= alike - 1) {
    const int i = FirstOf(alike);
    row->jump[At(entry + i)] = static_cast<std::int16_t>(runs.JumpAt(step, 0, i));
    row->begin[At(entry + i)] = 0;
    row->end[At(entry + i)] = JumpRow::kNoEnd;
  }
  for (std::size_t cell = At(step > 0 ? moves.cells_end[s - 1] : 0); cell < At(moves.cells_end[s]);
       ++cell) {
    const std::size_t place = At(entry + moves.pixel[cell]);
    row->jump[place] = static_cast<std::int16_t>(moves.jump[cell]);
    row->begin[place] = static_cast<std::int16_t>(moves.begin[cell]);
    row->end[place] = static_cast<std::int16_t>(moves.end[cell]);
  }
}

}  // namespace

void PlaneSetPrior::Assign(const std::vector<DisparityPlane>& planes, const PlaneSets& sets,
                           const VolumeShape& shape, JumpPolicy policy) {
  CheckSets(planes, sets);
  shape_ = shape;
  policy_ = policy;
  sets_.sets = sets.sets;
  sets.ids.copyTo(sets_.ids);
  planes_.clear();
  for (const DisparityPlane& plane : planes) {
    planes_.emplace_back(DisparityPlane{plane.a, plane.b, plane.c - shape.min_disparity});
  }
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      std::vector<PlaneStep>& steps = steps_[SlotOf({dx, dy})];
      steps.clear();
      for (const FixedPlane& plane : planes_) {
        steps.push_back(plane.StepBy(dx, dy, shape.disparities));
      }
    }
  }
  FindMoving();
  MapColumns();
  MapRows();
  MapRuns();
}

void PlaneSetPrior::FindMoving() {
  moving_.assign(sets_.sets.size(), MovingPlanes());
  for (std::size_t i = 0; i < moving_.size(); ++i) {
    const PlaneSet& set = sets_.sets[i];
    for (std::uint8_t k = 0; k < set.count; ++k) {
      if (!PlaneOf(set, k).IsConstant()) moving_[i].places[moving_[i].count++] = k;
    }
    FindPhases(set, &moving_[i]);
  }
}

void PlaneSetPrior::FindPhases(const PlaneSet& set, MovingPlanes* moving) const {
  constexpr std::int64_t kMost = std::int64_t{1} << (FixedPlane::kFractionBits - 1);
  moving->is_phased = set.count == 1;
  if (set.count != PlaneSet::kPhases) return;
  const FixedPlane& plane = PlaneOf(set, 0);
  const FixedPlane& below = PlaneOf(set, 1);
  const FixedPlane& above = PlaneOf(set, 2);
  const std::int64_t down = plane.HeightOver(below);
  const std::int64_t up = above.HeightOver(plane);
  if (!below.IsParallelTo(plane) || !above.IsParallelTo(plane)) return;
  if (down < 0 || down > kMost || up < 0 || up > kMost) return;
  moving->is_phased = true;
  moving->below = static_cast<std::uint32_t>(down);
  moving->above = static_cast<std::uint32_t>(up);
}

void PlaneSetPrior::MapColumns() {
  const int columns = sets_.ids.cols;
  column_of_.resize(static_cast<std::size_t>(shape_.width));
  column_begin_.assign(static_cast<std::size_t>(columns) + 1, shape_.width);
  for (int x = shape_.width - 1; x >= 0; --x) {
    const int column = CellOf(x, shape_.width, columns);
    column_of_[static_cast<std::size_t>(x)] = column;
    column_begin_[static_cast<std::size_t>(column)] = x;
  }
  // Columns narrower than a pixel may hold none; they begin where the next does.
  for (std::size_t c = static_cast<std::size_t>(columns); c-- > 0;) {
    column_begin_[c] = std::min(column_begin_[c], column_begin_[c + 1]);
  }
}

void PlaneSetPrior::MapRows() {
  row_of_.resize(At(shape_.height));
  for (int y = 0; y < shape_.height; ++y) row_of_[At(y)] = CellOf(y, shape_.height, sets_.ids.rows);
}

void PlaneSetPrior::MapRuns() {
  const int columns = sets_.ids.cols;
  runs_.clear();
  runs_end_.clear();
  for (int row = 0; row < sets_.ids.rows; ++row) {
    const std::uint16_t* ids = sets_.ids.ptr<std::uint16_t>(row);
    for (int begin = 0, end = 0; begin < columns; begin = end) {
      while (end < columns && ids[end] == ids[begin]) ++end;
      const Run run{column_begin_[At(begin)], column_begin_[At(end)], ids[begin]};
      if (moving_[run.set].count > 0 && run.begin < run.end) runs_.push_back(run);
    }
    runs_end_.push_back(runs_.size());
  }
}

void PlaneSetPrior::Jumps(int y, int x_begin, int x_end, PathStep step, JumpRow* row) const {
  JumpsOfSteps(y, x_begin, x_end, &step, 1, row);
}

void PlaneSetPrior::JumpsOfSteps(int y, int x_begin, int x_end, const PathStep* steps, int count,
                                 JumpRow* rows) const {
  for (int i = 0; i < count; ++i) rows[i].Reset(At(x_end - x_begin));
  const int y_p = y - steps[0].dy;
  if (y_p < 0 || y_p >= shape_.height) return;
  Question question{y, x_begin, x_end, steps, count, rows, x_begin};
  if (policy_ == JumpPolicy::kSameSurface && count <= kMaxPlaneSteps) {
    FollowSurfaces(question);
    return;
  }
  for (int i = 0; i < count; ++i) {
    question.steps = steps + i;
    question.step_count = 1;
    question.rows = rows + i;
    policy_ == JumpPolicy::kSameSurface ? FollowSurfaces(question) : FollowLabels(question);
  }
}

// The number of the set at the pixel column x, in a row of the set image.
std::size_t PlaneSetPrior::SetAt(int x, int row) const {
  return sets_.ids.ptr<std::uint16_t>(row)[column_of_[At(x)]];
}

// The first pixel column after x with another set.
int PlaneSetPrior::RunEnd(int x, int row) const {
  const std::uint16_t* ids = sets_.ids.ptr<std::uint16_t>(row);
  const int column = column_of_[At(x)];
  int next = column + 1;
  while (next < sets_.ids.cols && ids[next] == ids[column]) ++next;
  return column_begin_[At(next)];
}

const FixedPlane& PlaneSetPrior::PlaneOf(const PlaneSet& set, int k) const {
  return planes_[At(set.planes[At(k)])];
}

// The planes at each p, followed to all q.
void PlaneSetPrior::FollowSurfaces(const Question& question) const {
  int most_left = question.steps[0].dx;
  int most_right = most_left;
  for (int s = 1; s < question.step_count; ++s) {
    most_left = std::min(most_left, question.steps[s].dx);
    most_right = std::max(most_right, question.steps[s].dx);
  }
  const int begin = std::max(0, question.begin - most_right);
  const int end = std::min(shape_.width, question.end - most_left);
  const std::size_t row = At(row_of_[At(question.y - question.steps[0].dy)]);
  const Run* const last = runs_.data() + runs_end_[row];
  const Run* run = runs_.data() + (row > 0 ? runs_end_[row - 1] : 0);
  for (; run != last && run->begin < end; ++run) {
    const int run_end = std::min(end, run->end);
    for (int x = std::max(begin, run->begin); x < run_end; x += kMaxPlaneRun) {
      FollowAnyRun(question, run->set, x, std::min(kMaxPlaneRun, run_end - x));
    }
  }
}

void PlaneSetPrior::FollowAnyRun(const Question& question, std::size_t set, int x_p,
                                 int count) const {
  moving_[set].is_phased ? FollowPhases(question, set, x_p, count)
                         : FollowRun(question, set, x_p, count);
}

// A plane and its copies along `count` pixels p, followed to those q that are asked for.
void PlaneSetPrior::FollowPhases(const Question& question, std::size_t set_id, int x_p,
                                 int count) const {
  const PlaneSet& set = sets_.sets[set_id];
  const MovingPlanes& moving = moving_[set_id];
  const int y_p = question.y - question.steps[0].dy;
  std::array<PhasedPlaneMoves, kMaxPlaneSteps> moves;  // NOLINT(*-member-init): as far as read
  for (int s = 0; s < question.step_count; ++s) {
    const PathStep step = question.steps[s];
    JumpRow& row = question.rows[s];
    const int entry = x_p + step.dx - question.first_x;
    moves[At(s)] = {steps_[SlotOf(step)][At(set.planes[0])],
                    PixelsAsked(question, step, x_p, count),
                    row.jump.data() + entry,
                    row.begin.data() + entry,
                    row.end.data() + entry,
                    0};
  }
  const PlaneRun plane = PlaneOf(set, 0).RunFrom(x_p, y_p);
  FollowPhasedPlane({plane, moving.below, moving.above, count, shape_.disparities},
                    question.step_count, moves.data());
  StepBits several{};
  for (int s = 0; s < question.step_count; ++s) several[At(s)] = moves[At(s)].several;
  WriteSeveral(question, set, x_p, several);
}

// From which of `count` pixels p a step is asked for, bit by bit.
std::uint64_t PlaneSetPrior::PixelsAsked(const Question& question, PathStep step, int x_p,
                                         int count) const {
  const int shift = step.dx + x_p;
  return BitsFrom(std::max(question.begin, 0) - shift, std::min(question.end, shape_.width) - shift,
                  count);
}

// The planes of a set, not all of them constant, along `count` pixels p, followed to those q that
// are asked for.
void PlaneSetPrior::FollowRun(const Question& question, std::size_t set_id, int x_p,
                              int count) const {
  const PlaneSet& set = sets_.sets[set_id];
  const MovingPlanes& moving = moving_[set_id];
  // Set as far as they are read; clearing them would take longer than all else here.
  std::array<PlaneRun, PlaneSet::kMaxPlanes> planes;   // NOLINT(*-member-init)
  std::array<const PlaneStep*, kMaxPlaneSteps> steps;  // NOLINT(*-member-init)
  std::array<std::uint64_t, kMaxPlaneSteps> pixels;    // NOLINT(*-member-init)
  PlaneMoves moves;                                    // NOLINT(*-member-init)
  const int y_p = question.y - question.steps[0].dy;
  for (int k = 0; k < set.count; ++k) planes[At(k)] = PlaneOf(set, k).RunFrom(x_p, y_p);
  for (int s = 0; s < question.step_count; ++s) {
    const PathStep step = question.steps[s];
    steps[At(s)] = steps_[SlotOf(step)].data();
    pixels[At(s)] = PixelsAsked(question, step, x_p, count);
  }
  const PlaneRuns runs{
      planes.data(),      set.count,    moving.places.data(), moving.count,        count,
      shape_.disparities, steps.data(), set.planes.data(),    question.step_count, pixels.data()};
  FollowPlaneRuns(runs, &moves);
  for (int s = 0; s < question.step_count; ++s) {
    WriteMoves(runs, moves, s, x_p + question.steps[s].dx - question.first_x, question.rows + s);
  }
  WriteSeveral(question, set, x_p, moves.several);
}

// Writes what each step does at those pixels from x_p on at which several planes jump.
void PlaneSetPrior::WriteSeveral(const Question& question, const PlaneSet& set, int x_p,
                                 const StepBits& several) const {
  if (std::all_of(several.begin(), several.begin() + question.step_count,
                  [](std::uint64_t bits) { return bits == 0; })) {
    return;
  }
  const int y_p = question.y - question.steps[0].dy;
  PlaneColumns columns(planes_, set, x_p, y_p);
  for (int s = 0; s < question.step_count; ++s) {
    const PathStep step = question.steps[s];
    const int entry = x_p + step.dx - question.first_x;
    for (std::uint64_t bits = several[At(s)]; bits != 0; bits &= bits - 1) {
      const int i = FirstOf(bits);
      const SurfaceColumn& column = columns.At(i);
      SegmentWriter writer(entry + i, shape_.disparities, question.rows + s);
      for (int cell = 0; cell < column.cells(); ++cell) {
        const std::size_t plane = At(set.planes[column.surface(cell)]);
        const auto fraction = static_cast<std::uint32_t>(planes_[plane].FixedAt(x_p + i, y_p));
        writer.WriteUpTo(column.CellEnd(cell), steps_[SlotOf(step)][plane].JumpFrom(fraction));
      }
      writer.Finish();
    }
  }
}

// For the literal policy, one step: runs end where the set at p or at q does.
void PlaneSetPrior::FollowLabels(const Question& question) const {
  const PathStep step = question.steps[0];
  const int row_p = row_of_[At(question.y - step.dy)];
  const int row_q = row_of_[At(question.y)];
  // Pixels whose predecessor lies inside.
  const int begin = std::clamp(step.dx, question.begin, question.end);
  const int end = std::clamp(shape_.width + step.dx, begin, question.end);
  Question part = question;
  for (part.begin = begin; part.begin < end; part.begin = part.end) {
    const int x_p = part.begin - step.dx;
    part.end = std::min(
        {end, part.begin + kMaxPlaneRun, RunEnd(x_p, row_p) + step.dx, RunEnd(part.begin, row_q)});
    const std::size_t set_p = SetAt(x_p, row_p);
    const std::size_t set_q = SetAt(part.begin, row_q);
    const PlaneSet& at_p = sets_.sets[set_p];
    const PlaneSet& at_q = sets_.sets[set_q];
    if (at_p.count == 1 && set_p == set_q) {
      if (moving_[set_p].count > 0) FollowAnyRun(part, set_p, x_p, part.end - part.begin);
    } else if (at_p.count > 0 && at_q.count > 0) {
      FollowNearest(part, at_p, at_q);
    }
  }
}

// Each disparity steps from its nearest surface at p to its nearest surface at q: the cells of
// both columns cut it.
void PlaneSetPrior::FollowNearest(const Question& question, const PlaneSet& at_p,
                                  const PlaneSet& at_q) const {
  const PathStep step = question.steps[0];
  PlaneColumns columns_p(planes_, at_p, question.begin - step.dx, question.y - step.dy);
  PlaneColumns columns_q(planes_, at_q, question.begin, question.y);
  for (int n = 0; n < question.end - question.begin; ++n) {
    const SurfaceColumn& p = columns_p.At(n);
    const SurfaceColumn& q = columns_q.At(n);
    SegmentWriter writer(question.begin - question.first_x + n, shape_.disparities, question.rows);
    for (int i = 0, j = 0; i < p.cells() && j < q.cells();) {
      const int end_p = p.CellEnd(i);
      const int end_q = q.CellEnd(j);
      const int jump = std::clamp(q.value(j) - p.value(i), -shape_.disparities, shape_.disparities);
      writer.WriteUpTo(std::min(end_p, end_q), jump);
      if (end_p <= end_q) ++i;
      if (end_q <= end_p) ++j;
    }
    writer.Finish();
  }
}

}  // namespace stereo_sgmp
