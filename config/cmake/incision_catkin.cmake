# What makes this a catkin package: Python, ROS packages, messages. Included before any target is defined.

# catkin needs the system's Python, which holds catkin_pkg; another may come first on PATH.
if(NOT PYTHON_EXECUTABLE)
  set(PYTHON_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "Python that holds the ROS modules")
endif()
# catkin keeps only the folders that exist when it is configured, and our messages' Python modules come later.
if(NOT CATKIN_DEVEL_PREFIX)
  file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/devel/lib/python3/dist-packages")
endif()

set(ros_packages geometry_msgs roscpp std_msgs std_srvs tf2 tf2_geometry_msgs tf2_ros visualization_msgs)
find_package(catkin REQUIRED COMPONENTS message_generation ${ros_packages})

add_message_files(FILES CutPlane.msg CutReport.msg BodyState.msg)
generate_messages(DEPENDENCIES geometry_msgs std_msgs)

catkin_package(
  INCLUDE_DIRS include
  LIBRARIES incision incision_ros
  CATKIN_DEPENDS message_runtime ${ros_packages}
  DEPENDS EIGEN3 YAML_CPP)

set(ros_include_dirs ${catkin_INCLUDE_DIRS} "${CATKIN_DEVEL_PREFIX}/include")
