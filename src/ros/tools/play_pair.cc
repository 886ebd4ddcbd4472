// Stands in for a stereo camera: publishes one pair of pictures again and again.
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <ros/ros.h>
#include <CLI/CLI.hpp>

#include "ros/tools/pair_messages.h"
#include "ros/tools/ros_tool.h"
#include "tools/tool_main.h"

namespace stereo_sgmp {
namespace {

constexpr char kDescription[] =
    "Publishes a rectified stereo pair as a camera would, each time with the stamp of sending: "
    "image_rect and camera_info of both sides, and left/image_rect_color where the pictures have "
    "colour.";

struct Arguments {
  std::string scene;
  double rate = 30.0;
  std::string name_space = "stereo";
  std::string frame_id = "left_camera_optical_frame";
};

void AddFlags(CLI::App* app, Arguments* a) {
  app->add_option("SCENE_DIR", a->scene, "Folder with im0.png, im1.png and calib.txt")
      ->required()
      ->check(CLI::ExistingDirectory);
  app->add_option("--rate", a->rate, "Pairs per second")
      ->check(CLI::Range(1e-3, 1e4))
      ->capture_default_str();
  app->add_option("--namespace", a->name_space, "Namespace of the stereo camera")
      ->capture_default_str();
  app->add_option("--frame-id", a->frame_id, "The left camera's optical frame")
      ->capture_default_str();
}

// Messages of one type with their publishers.
template <class Message>
class Topics {
 public:
  Topics(ros::NodeHandle* nh, std::vector<std::pair<std::string, Message>> messages)
      : messages_(std::move(messages)) {
    for (const auto& [topic, message] : messages_) {
      publishers_.push_back(nh->advertise<Message>(topic, 2));
    }
  }

  void Publish(const ros::Time& stamp) {
    for (std::size_t i = 0; i < messages_.size(); ++i) {
      messages_[i].second.header.stamp = stamp;
      publishers_[i].publish(messages_[i].second);
    }
  }

 private:
  std::vector<std::pair<std::string, Message>> messages_;
  std::vector<ros::Publisher> publishers_;
};

void Run(const Arguments& a) {
  const Pair pair = LoadPair(a.scene);
  CheckMaster();
  std_msgs::Header header;
  header.frame_id = a.frame_id;
  const PairMessages messages = MakeMessages(pair, header, false);
  ros::NodeHandle nh(a.name_space);
  Topics<sensor_msgs::Image> images(&nh, messages.images);
  Topics<sensor_msgs::CameraInfo> infos(&nh, messages.infos);
  ros::WallRate rate(a.rate);
  while (ros::ok()) {
    const ros::Time now = ros::Time::now();
    infos.Publish(now);
    images.Publish(now);
    rate.sleep();
  }
}

}  // namespace
}  // namespace stereo_sgmp

int main(int argc, char** argv) {
  ros::init(argc, argv, "play_pair", ros::init_options::AnonymousName);
  stereo_sgmp::Arguments arguments;
  CLI::App app(stereo_sgmp::kDescription, "play_pair");
  stereo_sgmp::AddFlags(&app, &arguments);
  return stereo_sgmp::RunTool(argc, argv, &app, [&] { stereo_sgmp::Run(arguments); });
}
