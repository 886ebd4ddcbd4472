// The nodelet as a node of its own.
#include <nodelet/loader.h>
#include <ros/init.h>
#include <ros/names.h>
#include <ros/this_node.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "stereo_sgmp");
  nodelet::Loader loader;
  const nodelet::V_string arguments(argv + 1, argv + argc);
  if (!loader.load(ros::this_node::getName(), "stereo_sgmp/stereo_sgmp",
                   ros::names::getRemappings(), arguments)) {
    return 1;
  }
  ros::spin();
  return 0;
}
