#include "ros/conversions.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <cv_bridge/cv_bridge.h>
#include <sensor_msgs/image_encodings.h>
#include <boost/make_shared.hpp>

#include "stereo_sgmp/option_fields.h"

namespace stereo_sgmp {
namespace {

namespace enc = sensor_msgs::image_encodings;

// Interpolated disparities are not quantised; this is how finely they can be told apart, and
// what consumers know from OpenCV's matchers.
constexpr double kInterpolatedStep = 1.0 / 16.0;

double DisparityStep(const Options& options) {
  return options.refinement.subpixel == Subpixel::kNone ? 1.0 : kInterpolatedStep;
}

double LastDisparity(const Options& options) {
  return options.min_disparity + options.num_disparities - 1;
}

// Columns with at least one disparity whose match lies inside the right image.
sensor_msgs::RegionOfInterest ValidWindow(cv::Size size, const Options& options) {
  const int first = std::clamp(options.min_disparity, 0, size.width);
  const int beyond =
      std::clamp(size.width + static_cast<int>(LastDisparity(options)), first, size.width);
  sensor_msgs::RegionOfInterest window;
  window.x_offset = static_cast<std::uint32_t>(first);
  window.width = static_cast<std::uint32_t>(beyond - first);
  window.height = static_cast<std::uint32_t>(size.height);
  return window;
}

// An image message of `type`, and its pixels as a matrix that shares the message's memory.
cv::Mat Allocate(cv::Size size, int type, const std::string& encoding, sensor_msgs::Image* image) {
  image->height = static_cast<std::uint32_t>(size.height);
  image->width = static_cast<std::uint32_t>(size.width);
  image->encoding = encoding;
  image->step = image->width * static_cast<std::uint32_t>(CV_ELEM_SIZE(type));
  image->data.resize(std::size_t{image->step} * image->height);
  return cv::Mat(size, type, image->data.data(), image->step);
}

sensor_msgs::PointField FloatField(const std::string& name, std::size_t offset) {
  sensor_msgs::PointField field;
  field.name = name;
  field.offset = static_cast<std::uint32_t>(offset);
  field.datatype = sensor_msgs::PointField::FLOAT32;
  field.count = 1;
  return field;
}

// Where the fields of a point lie in a PointCloud2 message; the gaps are zero.
struct PackedPoint {
  float x, y, z;
  float padding;
  std::uint8_t b, g, r, unused;
  float confidence;
  float padding2[2];
};
static_assert(sizeof(PackedPoint) == 32 && offsetof(PackedPoint, b) == 16 &&
                  offsetof(PackedPoint, confidence) == 20,
              "the layout that is described");

template <class Point>
void DescribePoints(sensor_msgs::PointCloud2* message) {
  message->fields = {FloatField("x", offsetof(Point, x)), FloatField("y", offsetof(Point, y)),
                     FloatField("z", offsetof(Point, z)), FloatField("rgb", offsetof(Point, b)),
                     FloatField("confidence", offsetof(Point, confidence))};
  message->point_step = sizeof(Point);
}

// All but the points, for which there is room.
void DescribeCloud(int width, int height, const CloudLayout& layout, const std_msgs::Header& header,
                   sensor_msgs::PointCloud2* message) {
  message->header = header;
  message->width = static_cast<std::uint32_t>(width);
  message->height = static_cast<std::uint32_t>(height);
  message->is_bigendian = false;
  message->is_dense = layout.is_dense;
  layout.compact ? DescribePoints<CloudPoint>(message) : DescribePoints<PackedPoint>(message);
  message->row_step = message->point_step * message->width;
  message->data.resize(std::size_t{message->row_step} * message->height);
}

// The points of a message, of the type that describes them.
template <class Point>
Point* PointsOf(sensor_msgs::PointCloud2* message) {
  return reinterpret_cast<Point*>(message->data.data());
}

// The gaps between the fields: memory that is used again may have had other points.
void ClearGaps(CloudPoint* /*points*/, int /*count*/) {}

void ClearGaps(PackedPoint* points, int count) {
  for (int i = 0; i < count; ++i) {
    points[i].padding = 0.0f;
    points[i].padding2[0] = 0.0f;
    points[i].padding2[1] = 0.0f;
  }
}

template <class Point>
void WriteRows(const CloudRows& rows, Point* out) {
  for (int y = 0; y < rows.height(); ++y, out += rows.width()) {
    rows.Row(y, out);
    ClearGaps(out, rows.width());
  }
}

PackedPoint Packed(const CloudPoint& point) {
  PackedPoint packed{};
  packed.x = point.x;
  packed.y = point.y;
  packed.z = point.z;
  packed.b = point.b;
  packed.g = point.g;
  packed.r = point.r;
  packed.confidence = point.confidence;
  return packed;
}

stereo_sgmp::Plane ToPlane(const PlaneHypothesis& hypothesis, const StereoCamera& camera) {
  const StereoCamera::SpacePlane space = camera.ToSpace(hypothesis.plane);
  stereo_sgmp::Plane plane;
  plane.a = hypothesis.plane.a;
  plane.b = hypothesis.plane.b;
  plane.c = hypothesis.plane.c;
  for (int i = 0; i < 3; ++i) plane.normal[static_cast<std::size_t>(i)] = space.normal[i];
  plane.distance = space.distance;
  plane.support = hypothesis.support;
  plane.residual = hypothesis.residual;
  return plane;
}

void FillAlignment(const AlignmentReport& report, stereo_sgmp::Statistics* message) {
  message->alignment_applied = report.applied;
  message->alignment_scale = report.scale;
  message->alignment_offset = report.offset;
  message->alignment_inliers = report.inliers;
  message->alignment_median_offset = report.median_offset;
  message->alignment_residual = report.residual;
}

}  // namespace

DisparityLimits PublishedLimits(const MatchResult& result, const Options& options,
                                const StereoCamera& camera) {
  double lowest = options.min_disparity;
  double highest = LastDisparity(options);
  const cv::Mat valid = result.reason == 0;
  if (cv::countNonZero(valid) > 0) {
    double least = 0.0;
    double most = 0.0;
    cv::minMaxIdx(result.dense, &least, &most, nullptr, nullptr, valid);
    lowest = std::min(lowest, least);
    highest = std::max(highest, most);
  }
  const double margin = DisparityStep(options);
  return {lowest + camera.doffs - margin, highest + camera.doffs + margin};
}

stereo_msgs::DisparityImagePtr ToDisparityImage(const MatchResult& result, const Options& options,
                                                const StereoCamera& camera,
                                                const std_msgs::Header& header) {
  auto message = boost::make_shared<stereo_msgs::DisparityImage>();
  FillDisparityImage(result, options, camera, header, message.get());
  return message;
}

void FillDisparityImage(const MatchResult& result, const Options& options,
                        const StereoCamera& camera, const std_msgs::Header& header,
                        stereo_msgs::DisparityImage* message) {
  message->header = header;
  message->image.header = header;
  message->f = static_cast<float>(camera.focal_length);
  message->T = static_cast<float>(camera.baseline);
  message->valid_window = ValidWindow(result.dense.size(), options);
  const DisparityLimits limits = PublishedLimits(result, options, camera);
  message->min_disparity = static_cast<float>(limits.min);
  message->max_disparity = static_cast<float>(limits.max);
  message->delta_d = static_cast<float>(DisparityStep(options));

  cv::Mat disparity = Allocate(result.dense.size(), CV_32FC1, enc::TYPE_32FC1, &message->image);
  const float doffs = static_cast<float>(camera.doffs);
  const float invalid = message->min_disparity - 1.0f;
  for (int y = 0; y < disparity.rows; ++y) {
    const float* const dense = result.dense.ptr<float>(y);
    const std::uint8_t* const reason = result.reason.ptr<std::uint8_t>(y);
    float* const out = disparity.ptr<float>(y);
    for (int x = 0; x < disparity.cols; ++x) out[x] = reason[x] == 0 ? dense[x] + doffs : invalid;
  }
}

sensor_msgs::PointCloud2Ptr ToPointCloud2(const PointCloud& cloud, const CloudLayout& layout,
                                          const std_msgs::Header& header) {
  auto message = boost::make_shared<sensor_msgs::PointCloud2>();
  DescribeCloud(cloud.width, cloud.height, layout, header, message.get());
  const std::vector<CloudPoint>& points = cloud.points;
  if (layout.compact) {
    std::copy(points.begin(), points.end(), PointsOf<CloudPoint>(message.get()));
  } else {
    std::transform(points.begin(), points.end(), PointsOf<PackedPoint>(message.get()), Packed);
  }
  return message;
}

void FillPointCloud2(const CloudRows& rows, bool compact, const std_msgs::Header& header,
                     sensor_msgs::PointCloud2* message) {
  DescribeCloud(rows.width(), rows.height(), {compact, false}, header, message);
  if (compact) {
    WriteRows(rows, PointsOf<CloudPoint>(message));
  } else {
    WriteRows(rows, PointsOf<PackedPoint>(message));
  }
}

stereo_sgmp::PriorsPtr ToPriors(const PlanePriors& priors, const StereoCamera& camera,
                                const std_msgs::Header& header) {
  auto message = boost::make_shared<stereo_sgmp::Priors>();
  message->header = header;
  message->variant = NameOf(priors.variant);
  for (const PlaneHypothesis& hypothesis : priors.planes) {
    message->planes.push_back(ToPlane(hypothesis, camera));
  }
  message->labels.header = header;
  if (!priors.labels.empty()) {
    cv::Mat labels = Allocate(priors.labels.size(), CV_16SC1, enc::TYPE_16SC1, &message->labels);
    priors.labels.copyTo(labels);
  }
  return message;
}

stereo_sgmp::StatisticsPtr ToStatistics(const MatchResult& result, const std_msgs::Header& header) {
  const MatchStatistics& statistics = result.statistics;
  auto message = boost::make_shared<stereo_sgmp::Statistics>();
  message->header = header;
  message->variant = NameOf(result.priors.variant);
  message->frame_ms = statistics.frame_ms;
  for (const StageTime& time : statistics.stages) {
    stereo_sgmp::Stage stage;
    stage.name = time.name;
    stage.ms = time.ms;
    message->stages.push_back(stage);
  }
  message->planes = statistics.planes;
  message->density = statistics.density;
  for (std::size_t i = 0; i < message->reasons.size(); ++i) {
    message->reasons[i] = static_cast<std::uint32_t>(statistics.reasons[i]);
  }
  FillAlignment(statistics.alignment, message.get());
  return message;
}

sensor_msgs::ImagePtr ToImageMessage(const cv::Mat& image, const std::string& encoding,
                                     const std_msgs::Header& header) {
  return cv_bridge::CvImage(header, encoding, image).toImageMsg();
}

}  // namespace stereo_sgmp
