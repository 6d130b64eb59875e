#include <ros/console.h>
#include <ros/init.h>

#include "incision/ros/demo/handle.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "incision_handle");
  ros::NodeHandle node("~");  // outlives the errors: without a handle nothing is logged
  try {
    const incision::Handle handle(node, incision::loadHandleSettings(node));
    ros::spin();
    return 0;
  } catch (const std::exception& error) {
    ROS_FATAL_STREAM(error.what());
    return 1;
  }
}
