#include "ros/prior_markers.h"

#include <cstddef>

#include <boost/make_shared.hpp>

#include "io/prior_picture.h"
#include "stereo_sgmp/prior_polygons.h"

namespace stereo_sgmp {
namespace {

using visualization_msgs::Marker;

constexpr float kFillOpacity = 0.4F;
constexpr double kLineWidth = 0.01;  // m

Marker MakeMarker(const char* name, int type, double scale, const std_msgs::Header& header) {
  Marker marker;
  marker.header = header;
  marker.ns = name;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = scale;
  marker.color.a = 1.0F;
  return marker;
}

void Add(const Eigen::Vector3d& point, const std_msgs::ColorRGBA& color, Marker* marker) {
  geometry_msgs::Point message;
  message.x = point.x();
  message.y = point.y();
  message.z = point.z();
  marker->points.push_back(message);
  marker->colors.push_back(color);
}

std_msgs::ColorRGBA ColorOf(std::size_t plane, float opacity) {
  const cv::Vec3b bgr = PlaneColor(plane);
  std_msgs::ColorRGBA color;
  color.b = static_cast<float>(bgr[0]) / 255.0F;
  color.g = static_cast<float>(bgr[1]) / 255.0F;
  color.r = static_cast<float>(bgr[2]) / 255.0F;
  color.a = opacity;
  return color;
}

// A convex polygon as a fan of triangles.
void Fill(const PriorPolygon& polygon, Marker* marker) {
  const std_msgs::ColorRGBA color = ColorOf(polygon.plane, kFillOpacity);
  for (std::size_t i = 2; i < polygon.corners.size(); ++i) {
    Add(polygon.corners[0], color, marker);
    Add(polygon.corners[i - 1], color, marker);
    Add(polygon.corners[i], color, marker);
  }
}

void Outline(const PriorPolygon& polygon, Marker* marker) {
  const std_msgs::ColorRGBA color = ColorOf(polygon.plane, 1.0F);
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    Add(polygon.corners[i], color, marker);
    Add(polygon.corners[(i + 1) % polygon.corners.size()], color, marker);
  }
}

}  // namespace

visualization_msgs::MarkerArrayPtr ToPriorMarkers(const PlanePriors& priors, cv::Size image_size,
                                                  const StereoCamera& camera, double max_depth,
                                                  const std_msgs::Header& header) {
  Marker fill = MakeMarker("planes", Marker::TRIANGLE_LIST, 1.0, header);
  Marker outline = MakeMarker("outlines", Marker::LINE_LIST, kLineWidth, header);
  for (const PriorPolygon& polygon : PriorPolygons(priors, image_size, camera, max_depth)) {
    Fill(polygon, &fill);
    Outline(polygon, &outline);
  }
  // Viewers complain of lists without points.
  if (fill.points.empty()) fill.action = outline.action = Marker::DELETE;
  auto message = boost::make_shared<visualization_msgs::MarkerArray>();
  message->markers = {fill, outline};
  return message;
}

}  // namespace stereo_sgmp
