#include "scene/ground_truth.h"

#include <cstddef>
#include <cstdint>
#include <limits>

namespace stereo_sgmp {
namespace {

constexpr std::int16_t kNoLabel = -1;

// Finds what the left camera sees at a pixel, and whether the right one sees it too.
class Surveyor {
 public:
  Surveyor(const World& world, const StereoCamera& camera, const RowShift& right_shift,
           cv::Size size)
      : camera_(camera),
        right_shift_(right_shift),
        size_(size),
        left_(world, LeftView(camera)),
        right_(world, RightView(camera)) {}

  // labels: the number of the surface, for now.
  void Survey(int x, int y, GroundTruth* truth) const {
    constexpr std::uint8_t kNothing = 0;
    constexpr std::uint8_t kOccluded = 128;
    constexpr std::uint8_t kVisible = 255;
    const Hit hit = left_.Cast(x, y);
    const bool found = hit.surface >= 0;
    const double d = camera_.focal_length * camera_.baseline * hit.point.w - camera_.doffs;
    truth->disparity.at<float>(y, x) =
        found ? static_cast<float>(d) : std::numeric_limits<float>::infinity();
    truth->mask.at<std::uint8_t>(y, x) =
        !found ? kNothing : (SeenFromRight(hit, d, x, y) ? kVisible : kOccluded);
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    if (found) normal = left_.NormalAt(hit, x, y);
    truth->normals.at<cv::Vec3f>(y, x) = cv::Vec3d(normal.x(), normal.y(), normal.z());
    truth->labels.at<std::int16_t>(y, x) =
        found && left_.IsPlane(hit.surface) ? static_cast<std::int16_t>(hit.surface) : kNoLabel;
  }

  DisparityPlane PlaneOf(int surface) const {
    const ProjectedPatch::Linear& w = left_.PatchOf(surface).inverse_depth();
    const double scale = camera_.focal_length * camera_.baseline;
    return {scale * w.dx, scale * w.dy, scale * w.at_origin - camera_.doffs};
  }

 private:
  bool SeenFromRight(const Hit& hit, double d, int x, int y) const {
    constexpr double kRounding = 1e-7;  // of the square root at the limb of a round surface
    const double right_x = x - d;
    const double right_y = right_shift_.scale * y + right_shift_.offset;
    const bool inside = right_x >= 0.0 && right_x <= size_.width - 1 && right_y >= 0.0 &&
                        right_y <= size_.height - 1;
    return inside && right_.Cast(right_x, y).point.w <= hit.point.w * (1.0 + kRounding);
  }

  const StereoCamera& camera_;
  const RowShift& right_shift_;
  cv::Size size_;
  WorldView left_;
  WorldView right_;
};

// Keeps the planes that are seen: labels become their indices in `planes`, in the same order.
void NumberPlanes(const Surveyor& surveyor, std::size_t surfaces, GroundTruth* truth) {
  std::vector<std::int16_t> plane_of(surfaces, kNoLabel);
  constexpr std::int16_t kSeen = 0;
  for (const std::int16_t label : cv::Mat_<std::int16_t>(truth->labels)) {
    if (label != kNoLabel) plane_of[static_cast<std::size_t>(label)] = kSeen;
  }
  for (std::size_t i = 0; i < surfaces; ++i) {
    if (plane_of[i] == kNoLabel) continue;
    plane_of[i] = static_cast<std::int16_t>(truth->planes.size());
    truth->planes.push_back(surveyor.PlaneOf(static_cast<int>(i)));
  }
  for (int y = 0; y < truth->labels.rows; ++y) {
    for (int x = 0; x < truth->labels.cols; ++x) {
      std::int16_t& label = truth->labels.at<std::int16_t>(y, x);
      if (label != kNoLabel) label = plane_of[static_cast<std::size_t>(label)];
    }
  }
}

}  // namespace

GroundTruth RenderGroundTruth(const World& world, const StereoCamera& camera,
                              const RowShift& right_shift, cv::Size size, ThreadPool* pool) {
  const Surveyor surveyor(world, camera, right_shift, size);
  GroundTruth truth;
  truth.disparity.create(size, CV_32F);
  truth.mask.create(size, CV_8U);
  truth.normals.create(size, CV_32FC3);
  truth.labels.create(size, CV_16S);
  pool->ForRanges(size.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < size.width; ++x) surveyor.Survey(x, y, &truth);
    }
  });
  NumberPlanes(surveyor, world.patches.size(), &truth);
  return truth;
}

}  // namespace stereo_sgmp
