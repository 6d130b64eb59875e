# test/ros/*.test, each with a ROS master on a port of its own and a folder of its own for logs, so that they run beside
# one another.
file(GLOB rostests CONFIGURE_DEPENDS test/ros/*.test)
foreach(file IN LISTS rostests)
  get_filename_component(name ${file} NAME_WE)
  set(label quick)
  if(name MATCHES "_(full|realtime)$")
    set(label ${CMAKE_MATCH_1})
  endif()
  set(test ${label}.ros.${name})
  add_test(NAME ${test} COMMAND "${CATKIN_DEVEL_PREFIX}/env.sh" rostest ${file})
  set_tests_properties(${test} PROPERTIES
    LABELS ${label} TIMEOUT 300
    ENVIRONMENT "ROS_IP=127.0.0.1;ROS_HOME=${CMAKE_CURRENT_BINARY_DIR}/ros_home/${name}")
  if(label STREQUAL "realtime")
    set_tests_properties(${test} PROPERTIES RUN_SERIAL ON)
  endif()
endforeach()

# Which a test has loaded before the node's libraries.
add_library(incision_refusing_new SHARED EXCLUDE_FROM_ALL test/ros/refusing_new.cpp)
add_dependencies(tests incision_refusing_new)
