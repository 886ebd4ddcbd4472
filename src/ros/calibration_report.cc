#include "ros/calibration_report.h"

#include <cmath>
#include <sstream>
#include <thread>

#include "common/simd_target.h"
#include "stereo_sgmp/error_estimate.h"
#include "stereo_sgmp/matcher.h"

namespace stereo_sgmp {
namespace {

constexpr double kSure = 0.95;  // confidence of about the median pixel

std::string Metres(double depth) {
  std::ostringstream text;
  text.precision(3);
  if (std::isfinite(depth)) {
    text << depth << " m";
  } else {
    text << "infinity";
  }
  return text.str();
}

void DescribeErrors(const StereoCamera& camera, const Options& options, std::ostream* text) {
  const double nearest = camera.DepthOf(options.min_disparity + options.num_disparities - 1);
  const double farthest = camera.DepthOf(options.min_disparity);
  const double disparity_error = DisparityErrorAt(kSure, options);
  const char* separator = "; depth error (1 sigma, sure pixels)";
  for (const double depth : {1.0, 5.0, 10.0}) {
    *text << separator << " at " << depth << " m: ";
    separator = ",";
    if (depth < nearest || depth > farthest) {
      *text << "not searched";
    } else {
      *text << Metres(DepthErrorAt(camera, depth, disparity_error));
    }
  }
}

}  // namespace

std::string CalibrationReport(const StereoCamera& camera, cv::Size image_size,
                              const Options& options) {
  const int last = options.min_disparity + options.num_disparities - 1;
  const unsigned cores = std::thread::hardware_concurrency();
  std::ostringstream text;
  text.precision(4);
  text << "stereo camera of " << image_size.width << " x " << image_size.height
       << " pixels: baseline " << Metres(camera.baseline) << ", focal length "
       << camera.focal_length << " px, principal points " << camera.doffs
       << " px apart; searches depths from " << Metres(camera.DepthOf(last)) << " to "
       << Metres(camera.DepthOf(options.min_disparity)) << " (disparities " << options.min_disparity
       << " to " << last << ")";
  DescribeErrors(camera, options, &text);
  constexpr double kMegabyte = 1024.0 * 1024.0;
  text << "; memory "
       << std::lround(static_cast<double>(EstimateMemory(options, image_size)) / kMegabyte)
       << " MB, threads " << (options.threads > 0 ? options.threads : static_cast<int>(cores))
       << " on " << cores << " cores, " << SimdTargetName();
  return text.str();
}

std::string CalibrationLog::Update(const StereoCamera& camera, cv::Size image_size,
                                   const Options& options) {
  std::string report = CalibrationReport(camera, image_size, options);
  if (report == last_) return "";
  last_ = report;
  return report;
}

}  // namespace stereo_sgmp
