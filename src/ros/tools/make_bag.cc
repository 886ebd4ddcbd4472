// A bag of rectified image pairs with camera_info, to play into the nodelet.
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <cv_bridge/cv_bridge.h>
#include <rosbag/bag.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/image_encodings.h>
#include <CLI/CLI.hpp>
#include <opencv2/imgproc.hpp>

#include "io/calib.h"
#include "io/file_io.h"
#include "io/image.h"
#include "tools/tool_main.h"

namespace stereo_sgmp {
namespace {

namespace enc = sensor_msgs::image_encodings;

constexpr char kDescription[] =
    "Writes rectified stereo pairs into a ROS bag: image_rect and camera_info of both cameras, and "
    "left/image_rect_color where the pictures have colour. Play it with\n"
    "  roslaunch stereo_sgmp demo.launch bag:=$PWD/OUT.bag rviz:=true";

struct Arguments {
  std::string bag;
  std::vector<std::string> scenes;
  std::string left;
  std::string right;
  std::string calib;
  int frames = 1;
  double rate = 10.0;
  double start = 1.0e9;
  bool raw = false;
  std::string name_space = "stereo";
  std::string frame_id = "left_camera_optical_frame";
};

void AddFlags(CLI::App* app, Arguments* a) {
  app->add_option("OUT.bag", a->bag, "The bag that is written")->required();
  app->add_option("SCENE_DIR", a->scenes,
                  "Folders with im0.png, im1.png and calib.txt, as Middlebury's; one after another")
      ->check(CLI::ExistingDirectory);
  CLI::Option* left = app->add_option("--left", a->left, "Left picture, instead of folders");
  CLI::Option* right = app->add_option("--right", a->right, "Right picture");
  CLI::Option* calib =
      app->add_option("--calib", a->calib, "Middlebury's calib.txt (baseline: mm)");
  left->needs(right)->needs(calib);
  right->needs(left);
  calib->needs(left);
  app->add_option("--frames", a->frames, "How often each pair is repeated")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  app->add_option("--rate", a->rate, "Frames per second")
      ->check(CLI::Range(1e-3, 1e4))
      ->capture_default_str();
  app->add_option("--start", a->start, "Stamp of the first frame, seconds")
      ->check(CLI::Range(1.0, 4.0e9))
      ->capture_default_str();
  app->add_flag("--raw", a->raw,
                "Also image_raw, for pipelines that rectify (the pictures have no distortion)");
  app->add_option("--namespace", a->name_space, "Namespace of the stereo camera")
      ->capture_default_str();
  app->add_option("--frame-id", a->frame_id, "The left camera's optical frame")
      ->capture_default_str();
}

struct Pair {
  cv::Mat left;
  cv::Mat right;
  StereoCamera camera;
};

Pair LoadPair(const std::string& left, const std::string& right, const std::string& calib) {
  Pair pair{LoadImage(left), LoadImage(right), ReadCalibration(calib).camera};
  CheckPair(pair.left, left, pair.right, right);
  return pair;
}

std::vector<Pair> LoadPairs(const Arguments& a) {
  std::vector<Pair> pairs;
  if (!a.left.empty()) pairs.push_back(LoadPair(a.left, a.right, a.calib));
  for (const std::string& scene : a.scenes) {
    pairs.push_back(LoadPair(scene + "/im0.png", scene + "/im1.png", scene + "/calib.txt"));
  }
  if (pairs.empty()) {
    throw std::invalid_argument(
        "nothing to write; expected scene folders, or --left, --right and --calib");
  }
  return pairs;
}

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

class BagWriter {
 public:
  explicit BagWriter(const Arguments& arguments)
      : arguments_(arguments), bag_(arguments.bag, rosbag::bagmode::Write) {}

  // All messages of one frame; the stamp is the time of recording too.
  void WriteFrame(const Pair& pair, const ros::Time& stamp) {
    header_.stamp = stamp;
    header_.frame_id = arguments_.frame_id;
    const StereoCamera& camera = pair.camera;
    WriteCamera("left", pair.left, MakeInfo(camera, pair.left.size(), camera.cx, 0.0, header_));
    WriteCamera(
        "right", pair.right,
        MakeInfo(camera, pair.right.size(), camera.cx + camera.doffs, camera.baseline, header_));
    if (pair.left.channels() > 1) WriteImage("left/image_rect_color", Color(pair.left));
  }

 private:
  void WriteCamera(const std::string& side, const cv::Mat& image,
                   const sensor_msgs::CameraInfo& info) {
    WriteImage(side + "/image_rect", Gray(image));
    if (arguments_.raw) WriteImage(side + "/image_raw", image);
    Write(side + "/camera_info", info);
  }

  void WriteImage(const std::string& topic, const cv::Mat& image) {
    Write(topic, *cv_bridge::CvImage(header_, EncodingOf(image), image).toImageMsg());
  }

  template <class Message>
  void Write(const std::string& topic, const Message& message) {
    bag_.write("/" + arguments_.name_space + "/" + topic, header_.stamp, message);
  }

  const Arguments& arguments_;
  std_msgs::Header header_;
  rosbag::Bag bag_;
};

void Run(const Arguments& a) {
  const std::vector<Pair> pairs = LoadPairs(a);
  CheckWritable(a.bag);
  BagWriter writer(a);
  int frame = 0;
  for (const Pair& pair : pairs) {
    for (int i = 0; i < a.frames; ++i) {
      writer.WriteFrame(pair, ros::Time(a.start + frame++ / a.rate));
    }
  }
}

}  // namespace
}  // namespace stereo_sgmp

int main(int argc, char** argv) {
  stereo_sgmp::Arguments arguments;
  CLI::App app(stereo_sgmp::kDescription, "make_bag");
  stereo_sgmp::AddFlags(&app, &arguments);
  return stereo_sgmp::RunTool(argc, argv, &app, [&] { stereo_sgmp::Run(arguments); });
}
