#include "prior/normals/normal_prior.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "prior/normals/surface_placement.h"
#include "prior/segment_writer.h"

namespace stereo_sgmp {
namespace {

// Far outside of any search range; S^ as an index is limited to it.
constexpr int kLargestIndex = 16000;

void CheckSize(cv::Size size, const VolumeShape& shape) {
  if (size == cv::Size(shape.width, shape.height)) return;
  throw std::invalid_argument("The normal map is " + std::to_string(size.width) + "x" +
                              std::to_string(size.height) + " pixels; expected the image's size, " +
                              std::to_string(shape.width) + "x" + std::to_string(shape.height) +
                              ".");
}

// floor, which compilers turn into a call for processors of the first SIMD generations.
int Floor(float value) {
  const int truncated = static_cast<int>(value);
  return truncated - (static_cast<float>(truncated) > value ? 1 : 0);
}

}  // namespace

void NormalPrior::Assign(SurfaceFamily family, const cv::Mat& placed, const VolumeShape& shape) {
  CheckSize(family.shape.size(), shape);
  placed_.reset();
  if (!placed.empty()) placed_.emplace().Assign(placed, shape);
  shape_ = shape;
  family_ = std::move(family);
}

void NormalPrior::Jumps(int y, int x_begin, int x_end, PathStep step, JumpRow* row) const {
  row->Reset(static_cast<std::size_t>(x_end - x_begin));
  row->MoveAll();
  const int y_p = y - step.dy;
  if (y_p < 0 || y_p >= shape_.height) return;
  const int inside_begin = std::max(x_begin, step.dx);
  const int inside_end = std::min(x_end, shape_.width + step.dx);
  Stretch stretch;
  Steps steps;
  for (int x = inside_begin; x < inside_end; x += kMaxStretch) {
    stretch.count = std::min(kMaxStretch, inside_end - x);
    stretch.entry = x - x_begin;
    stretch.shape_p = family_.shape[y_p] + x - step.dx;
    stretch.shape_q = family_.shape[y] + x;
    const int* component_p = family_.component[y_p] + x - step.dx;
    if (!Join(component_p, family_.component[y] + x, &stretch)) continue;
    FindReached(stretch, &steps);
    Follow(stretch, &steps);
    Write(stretch, steps, row);
  }
  if (!placed_) return;
  CrossBorders(y, inside_begin, inside_end, step, row->jump.data() + (inside_begin - x_begin));
}

// `jump` is that of the pixel x_begin.
void NormalPrior::CrossBorders(int y, int x_begin, int x_end, PathStep step,
                               std::int16_t* jump) const {
  const int* at_p = family_.component[y - step.dy];
  const int* at_q = family_.component[y];
  for (int x = x_begin; x < x_end; ++x, ++jump) {
    const int p = at_p[x - step.dx];
    const int q = at_q[x];
    if (p == q || p == 0 || q == 0) continue;
    if (IntegratedNormals::CellOf(p) != IntegratedNormals::CellOf(q)) continue;
    *jump = placed_->JumpTo(x, y, step);
  }
}

// False where no pixel of the stretch is of one component with its predecessor.
bool NormalPrior::Join(const int* component_p, const int* component_q, Stretch* stretch) {
  const auto count = static_cast<std::size_t>(stretch->count);
  PerPixel<int> joined{};
  int any = 0;
  for (std::size_t i = 0; i < count; ++i) {
    joined[i] = component_p[i] != 0 && component_p[i] == component_q[i] ? -1 : 0;
    any |= joined[i];
  }
  stretch->joined = joined;
  return any != 0;
}

// Leaves out surfaces that are not the nearest to any disparity of the range in the stretch.
void NormalPrior::FindReached(const Stretch& stretch, Steps* steps) const {
  const auto [low, high] = std::minmax_element(stretch.shape_p, stretch.shape_p + stretch.count);
  const std::vector<float>& scales = family_.scales;
  steps->begin = 0;
  steps->end = scales.size();
  const int last = shape_.disparities - 1;
  while (steps->end - steps->begin > 1 && IndexOf(scales[steps->end - 2], *low) >= last) {
    --steps->end;
  }
  // The next surface is nearer to the range unless both round to one disparity.
  while (steps->end - steps->begin > 1 && IndexOf(scales[steps->begin + 1], *high) <= 0 &&
         (scales[steps->begin + 1] - scales[steps->begin]) * *low > 1.5F) {
    ++steps->begin;
  }
}

void NormalPrior::Follow(const Stretch& stretch, Steps* steps) const {
  const int limit = shape_.disparities;
  const auto count = static_cast<std::size_t>(stretch.count);
  PerPixel<int> at_p;
  PerPixel<int> at_q;
  steps->differ.fill(0);
  for (std::size_t k = steps->begin; k < steps->end; ++k) {
    Rasterize(family_.scales[k], stretch.shape_p, count, &at_p);
    Rasterize(family_.scales[k], stretch.shape_q, count, &at_q);
    for (std::size_t i = 0; i < count; ++i) {
      const int jump = std::clamp(at_q[i] - at_p[i], -limit, limit) & stretch.joined[i];
      steps->at_p[k][i] = static_cast<std::int16_t>(at_p[i]);
      steps->jump[k][i] = static_cast<std::int16_t>(jump);
      steps->differ[i] |= jump ^ steps->jump[steps->begin][i];
    }
  }
}

void NormalPrior::Write(const Stretch& stretch, const Steps& steps, JumpRow* row) const {
  for (int pixel = 0; pixel < stretch.count; ++pixel) {
    const auto i = static_cast<std::size_t>(pixel);
    const int entry = stretch.entry + pixel;
    if (steps.differ[i] == 0) {
      row->jump[static_cast<std::size_t>(entry)] = steps.jump[steps.begin][i];
      continue;
    }
    SegmentWriter writer(entry, shape_.disparities, row);
    std::size_t k = steps.begin;
    for (std::size_t next = k + 1; next < steps.end; ++next) {
      // Of surfaces that round to one disparity the lowest has the cell.
      if (steps.at_p[next][i] == steps.at_p[k][i]) continue;
      const int middle = (steps.at_p[k][i] + steps.at_p[next][i]) >> 1;
      writer.WriteUpTo(middle + 1, steps.jump[k][i]);
      k = next;
    }
    writer.WriteUpTo(shape_.disparities, steps.jump[k][i]);
    writer.Finish();
  }
}

// S^ of a surface as disparity indices.
void NormalPrior::Rasterize(float scale, const float* shape, std::size_t count,
                            PerPixel<int>* index) const {
  const int zero = shape_.min_disparity;
  const auto lowest = static_cast<float>(zero - kLargestIndex);
  const auto highest = static_cast<float>(zero + kLargestIndex);
  int* out = index->data();
  for (std::size_t i = 0; i < count; ++i) {
    const float rounded_up = family_.At(scale, shape[i]) + 0.5F;
    out[i] = Floor(std::min(std::max(rounded_up, lowest), highest)) - zero;
  }
}

int NormalPrior::IndexOf(float scale, float e) const {
  PerPixel<int> index;
  Rasterize(scale, &e, 1, &index);
  return index[0];
}

const OrientationPrior* NormalPriorBuilder::Build(
    const NormalPriorSettings& settings, const cv::Mat& normals, const cv::Mat& discontinuities,
    const StereoCamera& camera, const CoarseDisparity& coarse, const cv::Mat& left,
    const VolumeShape& shape, ThreadPool* pool) {
  CheckSize(normals.size(), shape);
  const IntegratedNormals integrated = IntegrateNormals(normals, discontinuities, camera, pool);
  if (settings.all_depths) {
    SurfaceFamily family =
        SurfacesAtAllDepths(integrated, camera.doffs, shape.min_disparity, shape.disparities);
    const PlacedSurfaces placed = PlaceSurfaces(integrated, coarse, left, camera.doffs, pool);
    family.component = placed.component;
    prior_.Assign(std::move(family), placed.disparity, shape);
  } else {
    const double middle = shape.min_disparity + 0.5 * (shape.disparities - 1);
    const double disparity = settings.disparity != 0.0 ? settings.disparity : middle;
    prior_.Assign(SurfaceAtDepth(integrated, camera.doffs, disparity), cv::Mat(), shape);
  }
  return &prior_;
}

}  // namespace stereo_sgmp
