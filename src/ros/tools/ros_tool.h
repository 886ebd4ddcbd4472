#ifndef STEREO_SGMP_ROS_TOOLS_ROS_TOOL_H_
#define STEREO_SGMP_ROS_TOOLS_ROS_TOOL_H_

#include <stdexcept>

#include <ros/ros.h>

namespace stereo_sgmp {

// Without a master, a node handle would wait for one without a word.
inline void CheckMaster() {
  if (ros::master::check()) return;
  throw std::runtime_error("no ROS master answers at " + ros::master::getURI() +
                           "; start roscore or a launch file first, or set ROS_MASTER_URI");
}

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_TOOLS_ROS_TOOL_H_
