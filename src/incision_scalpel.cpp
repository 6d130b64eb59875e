#include <ros/console.h>
#include <ros/init.h>

#include "incision/ros/demo/scalpel.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "incision_scalpel");
  ros::NodeHandle node("~");  // outlives the errors: without a handle nothing is logged
  try {
    incision::Scalpel(node, incision::loadScalpelSettings(node)).run();
    return 0;
  } catch (const std::exception& error) {
    ROS_FATAL_STREAM(error.what());
    return 1;
  }
}
