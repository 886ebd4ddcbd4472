# What makes this a catkin package: messages, dynamic_reconfigure and what others find of it.
# The environment that catkin makes for the tests names only folders that exist by then.
if(NOT CATKIN_DEVEL_PREFIX)
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/devel/lib/python3/dist-packages)
endif()
find_package(catkin REQUIRED COMPONENTS
  cv_bridge
  diagnostic_msgs
  diagnostic_updater
  dynamic_reconfigure
  geometry_msgs
  image_transport
  message_filters
  message_generation
  nodelet
  pluginlib
  rosbag
  roscpp
  sensor_msgs
  std_msgs
  stereo_msgs
  visualization_msgs
)

add_message_files(FILES
  Plane.msg
  Priors.msg
  Stage.msg
  Statistics.msg
)
generate_messages(DEPENDENCIES sensor_msgs std_msgs)
generate_dynamic_reconfigure_options(cfg/StereoSgmp.cfg)

catkin_package(
  INCLUDE_DIRS include
  LIBRARIES ${PROJECT_NAME}
  CATKIN_DEPENDS
    cv_bridge
    diagnostic_msgs
    diagnostic_updater
    dynamic_reconfigure
    geometry_msgs
    image_transport
    message_filters
    message_runtime
    nodelet
    pluginlib
    rosbag
    roscpp
    sensor_msgs
    std_msgs
    stereo_msgs
    visualization_msgs
  DEPENDS OpenCV
)
