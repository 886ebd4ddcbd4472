#include "prior/manhattan/manhattan_prior.h"

#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "prior/coarse_scale.h"
#include "prior/manhattan/line_segments.h"
#include "prior/manhattan/orientation_map.h"
#include "prior/nearest_planes.h"

namespace stereo_sgmp {
const OrientationPrior* ManhattanPrior::Estimate(const PriorOptions& options,
                                                 const CoarseDisparity& coarse, const cv::Mat& left,
                                                 const cv::Mat& coarse_left,
                                                 const StereoCamera& camera,
                                                 const VolumeShape& full, ThreadPool* threads) {
  camera.Check();
  if (left.size() != cv::Size(full.width, full.height)) {
    throw std::invalid_argument(
        "A Manhattan-world prior needs the left image in the size of the cost volume; pass the "
        "image that is matched.");
  }
  report_.planes.clear();
  report_.labels.release();
  const std::vector<LineSegment> lines = FindLineSegments(left);
  frame_ = FindManhattanFrame(lines, camera);
  if (!frame_) return nullptr;
  hypotheses_.Find(coarse, SmallestPlane(options, coarse.disparity.size()), threads);
  const cv::Size size = coarse.disparity.size();
  const CoarseScale scale = CoarseScale::Between(left.size(), size);
  ManhattanPlanes planes(frame_->directions, camera, scale);
  planes.AddHypotheses(hypotheses_.map(), coarse.disparity);
  planes.AddSegments(MapOrientations(lines, *frame_, camera, left.size(), size), coarse);
  Spread(planes.Sorted(), scale, coarse.disparity);
  if (options.spread) SpreadToRest(coarse_left, coarse.disparity);
  steering_.Assign(options, full_planes_, painter_.sets(), full);
  return steering_.attracting();
}

void ManhattanPrior::Spread(const std::vector<ManhattanPlane>& planes, const CoarseScale& scale,
                            const cv::Mat& disparity) {
  coarse_planes_.clear();
  full_planes_.clear();
  painter_.Start(disparity.size());
  for (const ManhattanPlane& plane : planes) {
    if (full_planes_.size() == PlaneSet::kMaxListed) break;
    painter_.Paint(static_cast<std::int16_t>(full_planes_.size()), plane.area, plane.corner);
    full_planes_.push_back(plane.found.plane);
    coarse_planes_.push_back(scale.ToCoarse(plane.found.plane));
    report_.planes.push_back(plane.found);
  }
  LabelNearestPlanes(painter_.sets(), coarse_planes_, disparity, &report_.labels);
}

// The pixels that no plane was found for take those of the pixels that look like them.
void ManhattanPrior::SpreadToRest(const cv::Mat& coarse_left, const cv::Mat& disparity) {
  report_.labels.copyTo(spread_);
  spreader_.Spread(coarse_left, &spread_);
  painter_.FillEmpty(spread_);
  LabelNearestPlanes(painter_.sets(), coarse_planes_, disparity, &report_.labels);
}

}  // namespace stereo_sgmp
