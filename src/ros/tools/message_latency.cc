// How old messages are when they arrive.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <ros/ros.h>
#include <CLI/CLI.hpp>

#include "ros/tools/ros_tool.h"
#include "tools/tool_main.h"

namespace stereo_sgmp {

// What is read of a message of any type that begins with a header.
struct StampedMessage {
  ros::Time stamp;
};

}  // namespace stereo_sgmp

namespace ros {
namespace message_traits {

template <>
struct MD5Sum<stereo_sgmp::StampedMessage> {
  static const char* value() { return "*"; }
  static const char* value(const stereo_sgmp::StampedMessage& /*message*/) { return value(); }
};

template <>
struct DataType<stereo_sgmp::StampedMessage> {
  static const char* value() { return "*"; }
  static const char* value(const stereo_sgmp::StampedMessage& /*message*/) { return value(); }
};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<stereo_sgmp::StampedMessage> {
  template <class Stream>
  static void read(Stream& stream, stereo_sgmp::StampedMessage& message) {
    std::uint32_t sequence = 0;
    stream.next(sequence);
    stream.next(message.stamp);
  }
};

}  // namespace serialization
}  // namespace ros

namespace stereo_sgmp {
namespace {

constexpr char kDescription[] =
    "Listens to topics whose messages begin with a header, and prints how many arrive a second and "
    "how long after their stamp. It reads nothing but the stamp, so that it takes little time of "
    "its own.";

struct Arguments {
  std::vector<std::string> topics;
  double seconds = 10.0;
  double warm_up = 3.0;
  double patience = 30.0;
};

void AddFlags(CLI::App* app, Arguments* a) {
  app->add_option("TOPIC", a->topics, "What to listen to")->required();
  app->add_option("--seconds", a->seconds, "How long to measure")
      ->check(CLI::Range(0.1, 1e6))
      ->capture_default_str();
  app->add_option("--warm-up", a->warm_up, "Seconds that are not measured, from the first message")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  app->add_option("--patience", a->patience, "Seconds to wait for the first message")
      ->check(CLI::Range(0.1, 1e6))
      ->capture_default_str();
}

// The latencies of one topic.
class Topic {
 public:
  Topic(ros::NodeHandle* nh, const std::string& name)
      : name_(name),
        subscriber_(nh->subscribe<StampedMessage>(
            name, 10, [this](const boost::shared_ptr<const StampedMessage>& m) { Add(m->stamp); },
            ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay())) {}

  const std::string& name() const { return name_; }

  bool HasAny() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return !milliseconds_.empty();
  }

  // Forgets those so far; returns them.
  std::vector<double> Take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(milliseconds_, {});
  }

 private:
  void Add(const ros::Time& stamp) {
    const ros::Time now = ros::Time::now();
    const std::lock_guard<std::mutex> lock(mutex_);
    milliseconds_.push_back((now.toSec() - stamp.toSec()) * 1e3);
  }

  const std::string name_;
  mutable std::mutex mutex_;
  std::vector<double> milliseconds_;
  ros::Subscriber subscriber_;  // last: it uses all of the above
};

// Between the two numbers around the place of the quantile.
double Quantile(const std::vector<double>& sorted, double part) {
  const double place = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

void Print(const std::string& topic, std::vector<double> latencies, double seconds) {
  std::sort(latencies.begin(), latencies.end());
  const double rate = static_cast<double>(latencies.size()) / seconds;
  if (latencies.empty()) {
    std::printf("%s: none arrived\n", topic.c_str());
    return;
  }
  std::printf("%s: %.1f Hz, median %.1f ms, 99 %% %.1f ms\n", topic.c_str(), rate,
              Quantile(latencies, 0.5), Quantile(latencies, 0.99));
}

void WaitForAll(const std::deque<Topic>& topics, double patience) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(patience);
  for (const Topic& topic : topics) {
    while (ros::ok() && !topic.HasAny()) {
      if (ros::WallTime::now() > end) {
        std::ostringstream text;
        text << "nothing arrived on " << topic.name() << " within " << patience
             << " s; `rostopic info` says who sends";
        throw std::runtime_error(text.str());
      }
      ros::WallDuration(0.01).sleep();
    }
  }
}

void Run(const Arguments& a) {
  CheckMaster();
  ros::NodeHandle nh;
  std::deque<Topic> topics;
  for (const std::string& name : a.topics) topics.emplace_back(&nh, name);
  ros::AsyncSpinner spinner(1);
  spinner.start();
  WaitForAll(topics, a.patience);
  ros::WallDuration(a.warm_up).sleep();
  for (Topic& topic : topics) topic.Take();
  std::printf("Measuring for %g s\n", a.seconds);
  std::fflush(stdout);
  ros::WallDuration(a.seconds).sleep();
  for (Topic& topic : topics) Print(topic.name(), topic.Take(), a.seconds);
}

}  // namespace
}  // namespace stereo_sgmp

int main(int argc, char** argv) {
  ros::init(argc, argv, "message_latency", ros::init_options::AnonymousName);
  stereo_sgmp::Arguments arguments;
  CLI::App app(stereo_sgmp::kDescription, "message_latency");
  stereo_sgmp::AddFlags(&app, &arguments);
  return stereo_sgmp::RunTool(argc, argv, &app, [&] { stereo_sgmp::Run(arguments); });
}
