#include "prior/plane_set_prior.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

#include <hwy/base.h>

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

// The lowest bit that is set; there has to be one.
int FirstOf(std::uint64_t bits) {
  return static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(bits));
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
  MapColumns();
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

void PlaneSetPrior::Jumps(int y, int x_begin, int x_end, PathStep step, JumpRow* row) const {
  row->Reset(static_cast<std::size_t>(x_end - x_begin));
  const int y_p = y - step.dy;
  // Pixels whose predecessor lies inside.
  const int inside_begin = std::clamp(step.dx, x_begin, x_end);
  const int inside_end = std::clamp(shape_.width + step.dx, inside_begin, x_end);
  if (y_p < 0 || y_p >= shape_.height) return;

  const std::uint16_t* ids_p = IdsOfRow(y_p);
  const std::uint16_t* ids_q = IdsOfRow(y);
  Stretch stretch;
  stretch.y = y;
  stretch.step = step;
  for (int x = inside_begin; x < inside_end; x = stretch.x_end) {
    const int x_p = x - step.dx;
    stretch.x_begin = x;
    stretch.x_end = std::min({inside_end, x + kMaxPlaneRun, RunEnd(ids_p, x_p) + step.dx});
    if (policy_ == JumpPolicy::kLiteral) {
      stretch.x_end = std::min(stretch.x_end, RunEnd(ids_q, x));
    }
    stretch.entry = x - x_begin;
    stretch.at_p = &sets_.sets[ids_p[column_of_[static_cast<std::size_t>(x_p)]]];
    stretch.at_q = &sets_.sets[ids_q[column_of_[static_cast<std::size_t>(x)]]];
    FillStretch(stretch, row);
  }
}

const std::uint16_t* PlaneSetPrior::IdsOfRow(int y) const {
  return sets_.ids.ptr<std::uint16_t>(CellOf(y, shape_.height, sets_.ids.rows));
}

// The first pixel column after x with another set.
int PlaneSetPrior::RunEnd(const std::uint16_t* ids, int x) const {
  int column = column_of_[static_cast<std::size_t>(x)];
  const std::uint16_t id = ids[column];
  do {
    ++column;
  } while (column < sets_.ids.cols && ids[column] == id);
  return column_begin_[static_cast<std::size_t>(column)];
}

const FixedPlane& PlaneSetPrior::PlaneOf(const PlaneSet& set, int k) const {
  return planes_[static_cast<std::size_t>(set.planes[static_cast<std::size_t>(k)])];
}

void PlaneSetPrior::FillStretch(const Stretch& stretch, JumpRow* row) const {
  const PlaneSet& set = *stretch.at_p;
  if (set.count == 0) return;
  const bool same_plane = policy_ == JumpPolicy::kSameSurface || stretch.at_p == stretch.at_q;
  if (policy_ == JumpPolicy::kSameSurface || (set.count == 1 && same_plane)) {
    FollowPlanes(stretch, row);
  } else if (stretch.at_q->count > 0) {
    FollowLabels(stretch, row);
  }
}

// The planes at p, each followed to q.
void PlaneSetPrior::FollowPlanes(const Stretch& stretch, JumpRow* row) const {
  const PlaneSet& set = *stretch.at_p;
  const int count = stretch.x_end - stretch.x_begin;
  const int x_p = stretch.x_begin - stretch.step.dx;
  const int y_p = stretch.y - stretch.step.dy;
  // Set as far as they are read; clearing them would take longer than all else here.
  std::array<PlaneRun, PlaneSet::kMaxPlanes> runs;  // NOLINT(*-pro-type-member-init)
  PlaneMoves moves;                                 // NOLINT(*-pro-type-member-init)
  for (int k = 0; k < set.count; ++k) {
    runs[static_cast<std::size_t>(k)] =
        PlaneOf(set, k).RunFrom(x_p, y_p, stretch.step.dx, stretch.step.dy, shape_.disparities);
  }
  FollowPlaneRuns(runs.data(), set.count, count, shape_.disparities, &moves);
  for (std::uint64_t alike = moves.alike; alike != 0; alike &= alike - 1) {
    const int i = FirstOf(alike);
    row->jump[At(stretch.entry + i)] = static_cast<std::int16_t>(runs[0].JumpAt(i));
  }
  for (std::size_t cell = 0; cell < At(moves.cells); ++cell) {
    const int i = moves.pixel[cell];
    const std::size_t entry = At(stretch.entry + i);
    const int jump = runs[At(moves.plane[cell])].JumpAt(i);
    row->jump[entry] = static_cast<std::int16_t>(moves.begin[cell] < moves.end[cell] ? jump : 0);
    row->begin[entry] = static_cast<std::int16_t>(moves.begin[cell]);
    row->end[entry] = static_cast<std::int16_t>(moves.end[cell]);
  }
  if (moves.several == 0) return;
  PlaneColumns columns(planes_, set, x_p, y_p);
  for (std::uint64_t several = moves.several; several != 0; several &= several - 1) {
    const int i = FirstOf(several);
    const SurfaceColumn& column = columns.At(i);
    SegmentWriter writer(stretch.entry + i, shape_.disparities, row);
    for (int cell = 0; cell < column.cells(); ++cell) {
      writer.WriteUpTo(column.CellEnd(cell), runs[At(column.surface(cell))].JumpAt(i));
    }
    writer.Finish();
  }
}

// Each disparity steps from its nearest surface at p to its nearest surface at q: the cells of
// both columns cut it.
void PlaneSetPrior::FollowLabels(const Stretch& stretch, JumpRow* row) const {
  PlaneColumns columns_p(planes_, *stretch.at_p, stretch.x_begin - stretch.step.dx,
                         stretch.y - stretch.step.dy);
  PlaneColumns columns_q(planes_, *stretch.at_q, stretch.x_begin, stretch.y);
  for (int n = 0; n < stretch.x_end - stretch.x_begin; ++n) {
    const SurfaceColumn& p = columns_p.At(n);
    const SurfaceColumn& q = columns_q.At(n);
    SegmentWriter writer(stretch.entry + n, shape_.disparities, row);
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
