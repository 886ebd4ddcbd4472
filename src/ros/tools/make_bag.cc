// A bag of rectified image pairs with camera_info, to play into the nodelet.
#include <stdexcept>
#include <string>
#include <vector>

#include <rosbag/bag.h>
#include <CLI/CLI.hpp>

#include "io/file_io.h"
#include "ros/tools/pair_messages.h"
#include "tools/tool_main.h"

namespace stereo_sgmp {
namespace {

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

std::vector<Pair> LoadPairs(const Arguments& a) {
  std::vector<Pair> pairs;
  if (!a.left.empty()) pairs.push_back(LoadPair(a.left, a.right, a.calib));
  for (const std::string& scene : a.scenes) pairs.push_back(LoadPair(scene));
  if (pairs.empty()) {
    throw std::invalid_argument(
        "nothing to write; expected scene folders, or --left, --right and --calib");
  }
  return pairs;
}

// The stamp is the time of recording too.
void WriteFrame(const Arguments& a, const Pair& pair, const ros::Time& stamp, rosbag::Bag* bag) {
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = a.frame_id;
  const PairMessages messages = MakeMessages(pair, header, a.raw);
  const std::string camera = "/" + a.name_space + "/";
  for (const auto& [topic, image] : messages.images) bag->write(camera + topic, stamp, image);
  for (const auto& [topic, info] : messages.infos) bag->write(camera + topic, stamp, info);
}

void Run(const Arguments& a) {
  const std::vector<Pair> pairs = LoadPairs(a);
  CheckWritable(a.bag);
  rosbag::Bag bag(a.bag, rosbag::bagmode::Write);
  int frame = 0;
  for (const Pair& pair : pairs) {
    for (int i = 0; i < a.frames; ++i) {
      WriteFrame(a, pair, ros::Time(a.start + frame++ / a.rate), &bag);
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
