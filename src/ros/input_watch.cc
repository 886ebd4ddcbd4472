#include "ros/input_watch.h"

#include <algorithm>
#include <sstream>

namespace stereo_sgmp {
namespace {

const ros::WallDuration kPatience(5.0);

std::string Base(const std::string& topic) { return topic.substr(topic.rfind('/') + 1); }

std::string Parent(const std::string& topic) { return topic.substr(0, topic.rfind('/')); }

// "" where there is none.
std::string RawImageBeside(const std::string& topic, const std::vector<PublishedTopic>& published) {
  const std::string raw = Parent(topic) + "/image_raw";
  const bool found = std::any_of(published.begin(), published.end(),
                                 [&](const PublishedTopic& other) { return other.name == raw; });
  return found ? raw : "";
}

// Topics of the same type whose last name is the same, else all of the type; the first few.
std::string Candidates(const InputTopic& input, const std::vector<PublishedTopic>& published) {
  constexpr int kMost = 4;
  for (const bool same_base : {true, false}) {
    std::string names;
    int count = 0;
    for (const PublishedTopic& other : published) {
      if (other.type != input.type || other.name == input.name) continue;
      if (same_base && Base(other.name) != Base(input.name)) continue;
      if (++count > kMost) break;
      names += (names.empty() ? "" : ", ") + other.name;
    }
    if (!names.empty()) return names;
  }
  return "";
}

std::string AdviceFor(const InputTopic& input, const std::vector<PublishedTopic>& published) {
  if (input.publishers > 0) {
    return "its publisher is connected but sends nothing: see that the driver runs, and that each "
           "machine reaches the other by the name in ROS_HOSTNAME or ROS_IP (rostopic hz " +
           input.name + ")";
  }
  const std::string raw = RawImageBeside(input.name, published);
  if (!raw.empty() && Base(input.name) != "image_raw") {
    return "nobody publishes it, but there is " + raw +
           ": rectify it, by rectify:=true of stereo_sgmp.launch or by image_proc";
  }
  const std::string candidates = Candidates(input, published);
  if (candidates.empty()) return "nobody publishes it, nor any other " + input.type;
  return "nobody publishes it; of its type there are " + candidates +
         ": set left:= and right:= or ROS_NAMESPACE, or remap";
}

}  // namespace

std::string SilenceAdvice(const std::vector<InputTopic>& inputs,
                          const std::vector<PublishedTopic>& published) {
  std::ostringstream text;
  text << "nothing arrives; expected messages on " << inputs.size() << " topics";
  for (const InputTopic& input : inputs) {
    text << "\n  " << input.name << " (" << input.received
         << " messages): " << AdviceFor(input, published);
  }
  return text.str();
}

void InputWatch::Reset() {
  received_ = 0;
  since_ = ros::WallTime();
}

bool InputWatch::IsSilent(const std::vector<InputTopic>& inputs, const ros::WallTime& now) {
  std::uint64_t received = 0;
  for (const InputTopic& input : inputs) received += input.received;
  if (since_.isZero() || received != received_) {
    received_ = received;
    since_ = now;
    return false;
  }
  if (now - since_ < kPatience) return false;
  since_ = now;
  return true;
}

}  // namespace stereo_sgmp
