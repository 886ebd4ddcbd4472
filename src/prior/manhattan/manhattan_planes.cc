#include "prior/manhattan/manhattan_planes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "prior/manhattan/viewing_ray.h"

namespace stereo_sgmp {
namespace {

// Distance from a plane up to which a pixel votes for it, coarse disparities.
constexpr double kTolerance = 0.75;
// Votes that a plane of a segment needs: at least so many and this share of the segment.
constexpr int kMinVotes = 30;
constexpr double kMinVoteShare = 0.05;
// Segments end this far before the lines around them, coarse pixels.
constexpr int kMargin = 3;
// Cosine of the angle (10 degrees) by which a plane may be turned, and the distance from its
// pixels that this may add, root mean square, coarse disparities.
constexpr double kTurnCosine = 0.985;
constexpr double kTurnError = 0.2;

// The pixels of each label 0 ... count - 1; T is the type of the labels.
template <typename T>
std::vector<std::vector<cv::Point>> PixelsOfLabels(const cv::Mat& labels, std::size_t count) {
  std::vector<std::vector<cv::Point>> pixels(count);
  for (int y = 0; y < labels.rows; ++y) {
    const T* row = labels.ptr<T>(y);
    for (int x = 0; x < labels.cols; ++x) {
      if (row[x] >= 0) pixels[static_cast<std::size_t>(row[x])].emplace_back(x, y);
    }
  }
  return pixels;
}

void SetAreaToHull(const std::vector<cv::Point>& pixels, ManhattanPlane* plane) {
  std::vector<cv::Point> hull;
  cv::convexHull(pixels, hull);
  const cv::Rect box = cv::boundingRect(hull);
  for (cv::Point& point : hull) point -= box.tl();
  plane->area = cv::Mat::zeros(box.size(), CV_8UC1);
  cv::fillConvexPoly(plane->area, hull, cv::Scalar(255));
  plane->corner = box.tl();
}

void SetAreaToDilated(const std::vector<cv::Point>& pixels, cv::Size image, ManhattanPlane* plane) {
  cv::Rect box = cv::boundingRect(pixels);
  box -= cv::Point(kMargin, kMargin);
  box += cv::Size(2 * kMargin, 2 * kMargin);
  box &= cv::Rect(cv::Point(), image);
  plane->area = cv::Mat::zeros(box.size(), CV_8UC1);
  for (const cv::Point& pixel : pixels) plane->area.at<std::uint8_t>(pixel - box.tl()) = 255;
  cv::dilate(plane->area, plane->area, cv::Mat(), cv::Point(-1, -1), kMargin);
  plane->corner = box.tl();
}

}  // namespace

ManhattanPlanes::ManhattanPlanes(const Eigen::Matrix3d& directions, const StereoCamera& camera,
                                 const CoarseScale& scale)
    : directions_(directions), camera_(camera), scale_(scale) {}

void ManhattanPlanes::AddHypotheses(const PlaneMap& map, const cv::Mat& disparity) {
  const auto pixels = PixelsOfLabels<std::int16_t>(map.labels, map.planes.size());
  for (std::size_t i = 0; i < map.planes.size(); ++i) {
    const CoarsePlane& coarse = map.planes[i];
    const PlaneHypothesis found{scale_.ToFull(coarse.plane), coarse.area, coarse.rms * scale_.x};
    ManhattanPlane plane;
    plane.found = Turned(found, pixels[i], disparity).value_or(found);
    SetAreaToHull(pixels[i], &plane);
    planes_.push_back(plane);
  }
}

void ManhattanPlanes::AddSegments(const cv::Mat& orientations, const CoarseDisparity& coarse) {
  cv::Mat segments;
  for (int direction = 0; direction < 3; ++direction) {
    const int count = cv::connectedComponents(orientations == direction, segments, 4, CV_32S);
    const auto pixels = PixelsOfLabels<std::int32_t>(segments, static_cast<std::size_t>(count));
    // Label 0 is what lies outside of all segments.
    for (std::size_t i = 1; i < pixels.size(); ++i) AddSegment(direction, pixels[i], coarse);
  }
}

std::vector<ManhattanPlane> ManhattanPlanes::Sorted() const {
  std::vector<ManhattanPlane> sorted = planes_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const ManhattanPlane& l, const ManhattanPlane& r) {
                     return l.found.support > r.found.support;
                   });
  return sorted;
}

PlaneVote ManhattanPlanes::VoteOf(int direction, const cv::Point& pixel,
                                  const cv::Mat& disparity) const {
  const Eigen::Vector3d ray =
      ViewingRay(camera_, (pixel.x + 0.5) * scale_.x - 0.5, (pixel.y + 0.5) * scale_.y - 0.5);
  return {directions_.col(direction).dot(ray),
          disparity.at<float>(pixel) * scale_.x + camera_.doffs};
}

// d' = rho n.(u, v, f) is Eq. 15 with h = b / rho.
PlaneHypothesis ManhattanPlanes::Found(int direction, const ConstrainedPlane& constrained) const {
  const DisparityPlane plane =
      camera_.ToDisparity({directions_.col(direction), camera_.baseline / constrained.rho});
  return {plane, constrained.support, constrained.rms};
}

// The plane with the normal nearest to that of `found`, or none where its pixels contradict.
std::optional<PlaneHypothesis> ManhattanPlanes::Turned(const PlaneHypothesis& found,
                                                       const std::vector<cv::Point>& pixels,
                                                       const cv::Mat& disparity) const {
  int direction = 0;
  const double cosine = (directions_.transpose() * camera_.ToSpace(found.plane).normal)
                            .cwiseAbs()
                            .maxCoeff(&direction);
  if (cosine < kTurnCosine) return std::nullopt;
  std::vector<PlaneVote> votes;
  votes.reserve(pixels.size());
  for (const cv::Point& pixel : pixels) votes.push_back(VoteOf(direction, pixel, disparity));
  ConstrainedPlane constrained = FitConstrainedPlane(votes);
  constrained.support = found.support;
  if (constrained.rms > std::hypot(found.residual, kTurnError * scale_.x)) return std::nullopt;
  return Found(direction, constrained);
}

void ManhattanPlanes::AddSegment(int direction, const std::vector<cv::Point>& pixels,
                                 const CoarseDisparity& coarse) {
  std::vector<PlaneVote> votes;
  for (const cv::Point& pixel : pixels) {
    if (coarse.confident.at<std::uint8_t>(pixel) == 0) continue;
    votes.push_back(VoteOf(direction, pixel, coarse.disparity));
  }
  const auto share = std::lround(kMinVoteShare * static_cast<double>(pixels.size()));
  const int min_votes = std::max(kMinVotes, static_cast<int>(share));
  for (const ConstrainedPlane& constrained :
       FindConstrainedPlanes(std::move(votes), kTolerance * scale_.x, min_votes)) {
    ManhattanPlane plane;
    plane.found = Found(direction, constrained);
    SetAreaToDilated(pixels, coarse.disparity.size(), &plane);
    planes_.push_back(plane);
  }
}

}  // namespace stereo_sgmp
