// Messages from results. All carry the header given, that of the left image.
#ifndef STEREO_SGMP_ROS_CONVERSIONS_H_
#define STEREO_SGMP_ROS_CONVERSIONS_H_

#include <string>

#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Header.h>
#include <stereo_msgs/DisparityImage.h>
#include <stereo_sgmp/Priors.h>
#include <stereo_sgmp/Statistics.h>
#include <opencv2/core.hpp>

#include "geometry/cloud_rows.h"
#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/options.h"
#include "stereo_sgmp/point_cloud.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// Published disparities are adjusted for the principal points, d = x_l - x_r - (cx_l - cx_r), so
// that z = f T / d; those of the matcher are x_l - x_r. This is the range of the published ones.
struct DisparityLimits {
  double min = 0.0;  // just below every valid disparity
  double max = 0.0;  // just above
};

// The limits of the search, widened where filling and smoothing went beyond.
DisparityLimits PublishedLimits(const MatchResult& result, const Options& options,
                                const StereoCamera& camera);

// The filtered disparities. Invalid pixels are min_disparity - 1: finite, since consumers fail
// on NaN and infinity, and below min_disparity, as the message demands.
stereo_msgs::DisparityImagePtr ToDisparityImage(const MatchResult& result, const Options& options,
                                                const StereoCamera& camera,
                                                const std_msgs::Header& header);

// The same into a message whose memory is used again.
void FillDisparityImage(const MatchResult& result, const Options& options,
                        const StereoCamera& camera, const std_msgs::Header& header,
                        stereo_msgs::DisparityImage* message);

struct CloudLayout {
  bool compact = false;   // 20 bytes a point; else 32, aligned for SIMD as PCL's points are
  bool is_dense = false;  // all points are valid
};

// With the fields x y z rgb confidence.
sensor_msgs::PointCloud2Ptr ToPointCloud2(const PointCloud& cloud, const CloudLayout& layout,
                                          const std_msgs::Header& header);

// The same of an organised cloud, into a message whose memory is used again.
void FillPointCloud2(const CloudRows& rows, bool compact, const std_msgs::Header& header,
                     sensor_msgs::PointCloud2* message);

stereo_sgmp::PriorsPtr ToPriors(const PlanePriors& priors, const StereoCamera& camera,
                                const std_msgs::Header& header);

// All but what only the nodelet knows: latency and the counts of frames.
stereo_sgmp::StatisticsPtr ToStatistics(const MatchResult& result, const std_msgs::Header& header);

sensor_msgs::ImagePtr ToImageMessage(const cv::Mat& image, const std::string& encoding,
                                     const std_msgs::Header& header);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_CONVERSIONS_H_
