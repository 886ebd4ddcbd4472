#include "ros/map_images.h"

#include <limits>

#include "io/color_map.h"
#include "io/prior_picture.h"
#include "stereo_sgmp/depth.h"
#include "stereo_sgmp/error_estimate.h"

namespace stereo_sgmp {
namespace {

constexpr char kFloat[] = "32FC1";
constexpr char kColor[] = "bgr8";

cv::Mat Confidence(const MatchedFrame& frame) { return frame.result.confidence; }

cv::Mat ConfidencePicture(const MatchedFrame& frame) {
  return ColorConfidence(frame.result.confidence);
}

cv::Mat Depth(const MatchedFrame& frame) {
  cv::Mat depth;
  ComputeDepth(frame.result, frame.camera, &depth);
  return depth;
}

// In pixels of the images that came, which are larger than those of the images that were matched.
cv::Mat DisparityError(const MatchedFrame& frame) {
  cv::Mat error;
  EstimateDisparityError(frame.result, frame.options, &error);
  if (frame.scale != 1.0) error *= 1.0 / frame.scale;
  return error;
}

cv::Mat DepthError(const MatchedFrame& frame) {
  cv::Mat error;
  EstimateDepthError(frame.result, DisparityError(frame), frame.camera, &error);
  return error;
}

cv::Mat PlanePicture(const MatchedFrame& frame) {
  return PriorPicture(frame.result.priors, frame.result.dense.size());
}

}  // namespace

const std::array<MapImage, kMapImageCount>& MapImages() {
  static const std::array<MapImage, kMapImageCount> kImages{
      {{"depth", kFloat, Depth},
       {"confidence", kFloat, Confidence},
       {"error_disparity", kFloat, DisparityError},
       {"error_depth", kFloat, DepthError},
       {"disparity_color", kColor, DisparityPicture},
       {"confidence_color", kColor, ConfidencePicture},
       {"priors_color", kColor, PlanePicture}}};
  return kImages;
}

cv::Mat DisparityPicture(const MatchedFrame& frame) {
  cv::Mat disparity;
  FilteredDisparity(frame.result, std::numeric_limits<float>::infinity(), &disparity);
  const Options& options = frame.options;
  return ColorDisparity(disparity, options.min_disparity,
                        options.min_disparity + options.num_disparities - 1);
}

}  // namespace stereo_sgmp
