#include <ros/console.h>
#include <ros/init.h>

#include "incision/ros/node.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "incision");
  const ros::NodeHandle keeps_ros_up;  // without a handle nothing is logged
  try {
    incision::IncisionNode().run();
    return 0;
  } catch (const std::exception& error) {
    ROS_FATAL_STREAM(error.what());
    return 1;
  }
}
