#include "ros/tools/pair_messages.h"

#include <cstdint>

#include <cv_bridge/cv_bridge.h>
#include <sensor_msgs/image_encodings.h>
#include <opencv2/imgproc.hpp>

#include "io/calib.h"
#include "io/image.h"

namespace stereo_sgmp {
namespace {

namespace enc = sensor_msgs::image_encodings;

// The colour encoding of a picture with colour, the gray one otherwise.
std::string EncodingOf(const cv::Mat& image) {
  const bool deep = image.depth() == CV_16U;
  if (image.channels() == 1) return deep ? enc::MONO16 : enc::MONO8;
  if (image.channels() == 3) return deep ? enc::BGR16 : enc::BGR8;
  return deep ? enc::BGRA16 : enc::BGRA8;
}

cv::Mat Gray(const cv::Mat& image) {
  if (image.channels() == 1) return image;
  cv::Mat gray;
  cv::cvtColor(image, gray, image.channels() == 3 ? cv::COLOR_BGR2GRAY : cv::COLOR_BGRA2GRAY);
  return gray;
}

// 8-bit BGR, the colour encoding that every consumer takes.
cv::Mat Color(const cv::Mat& image) {
  cv::Mat color = image;
  if (image.channels() == 4) cv::cvtColor(image, color, cv::COLOR_BGRA2BGR);
  if (color.depth() == CV_16U) color.convertTo(color, CV_8U, 1.0 / 257.0);
  return color;
}

// Of a camera without distortion whose centre is `offset` metres right of the left camera's.
sensor_msgs::CameraInfo MakeInfo(const StereoCamera& camera, cv::Size size, double cx,
                                 double offset, const std_msgs::Header& header) {
  const double f = camera.focal_length;
  sensor_msgs::CameraInfo info;
  info.header = header;
  info.width = static_cast<std::uint32_t>(size.width);
  info.height = static_cast<std::uint32_t>(size.height);
  info.distortion_model = "plumb_bob";
  info.D.assign(5, 0.0);
  info.K = {f, 0, cx, 0, f, camera.cy, 0, 0, 1};
  info.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  info.P = {f, 0, cx, -f * offset, 0, f, camera.cy, 0, 0, 0, 1, 0};
  return info;
}

}  // namespace

Pair LoadPair(const std::string& left, const std::string& right, const std::string& calib) {
  Pair pair{LoadImage(left), LoadImage(right), ReadCalibration(calib).camera};
  CheckPair(pair.left, left, pair.right, right);
  return pair;
}

Pair LoadPair(const std::string& scene) {
  return LoadPair(scene + "/im0.png", scene + "/im1.png", scene + "/calib.txt");
}

PairMessages MakeMessages(const Pair& pair, const std_msgs::Header& header, bool raw) {
  PairMessages messages;
  const auto add_image = [&](const std::string& topic, const cv::Mat& image) {
    messages.images.emplace_back(topic, sensor_msgs::Image());
    cv_bridge::CvImage(header, EncodingOf(image), image).toImageMsg(messages.images.back().second);
  };
  const auto add_side = [&](const std::string& side, const cv::Mat& image, double cx,
                            double offset) {
    add_image(side + "/image_rect", Gray(image));
    if (raw) add_image(side + "/image_raw", image);
    messages.infos.emplace_back(side + "/camera_info",
                                MakeInfo(pair.camera, image.size(), cx, offset, header));
  };
  const StereoCamera& camera = pair.camera;
  add_side("left", pair.left, camera.cx, 0.0);
  add_side("right", pair.right, camera.cx + camera.doffs, camera.baseline);
  if (pair.left.channels() > 1) add_image("left/image_rect_color", Color(pair.left));
  return messages;
}

}  // namespace stereo_sgmp
