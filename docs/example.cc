#include <iostream>

#include <opencv2/imgcodecs.hpp>

#include "stereo_sgmp/matcher.h"
#include "stereo_sgmp/point_cloud.h"
#include "stereo_sgmp/presets.h"

int main() {
  const cv::Mat left = cv::imread("left.png");
  const cv::Mat right = cv::imread("right.png");

  stereo_sgmp::Options options = stereo_sgmp::PresetOptions("default");
  options.num_disparities = 96;
  stereo_sgmp::Matcher matcher(options);  // keeps its buffers: one for each camera pair
  stereo_sgmp::MatchResult result;
  matcher.Match(left, right, &result);

  stereo_sgmp::StereoCamera camera;
  camera.focal_length = 700.0;  // pixels
  camera.cx = left.cols / 2.0;
  camera.cy = left.rows / 2.0;
  camera.baseline = 0.12;  // metres
  stereo_sgmp::PointCloud cloud;
  stereo_sgmp::ComputePointCloud(result, camera, left, stereo_sgmp::CloudOptions(), &cloud);

  std::cout << "planes: " << result.statistics.planes
            << ", share of valid pixels: " << result.statistics.density << '\n';
}
