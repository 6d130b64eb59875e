# The report's sections in test/report/<section>/: programs, or measure.py where a section drives others. The target
# `report` builds them. ctest runs each with --quick and fails where a claim does not hold, then draws the report.
add_custom_target(report DEPENDS incision_batch)
add_dependencies(tests report)

add_library(incision_findings STATIC EXCLUDE_FROM_ALL test/report/findings.cpp)
incision_compile(incision_findings)
target_include_directories(incision_findings PUBLIC "${PROJECT_SOURCE_DIR}/test")
target_link_libraries(incision_findings PUBLIC nlohmann_json::nlohmann_json)

set(report_folder "${CMAKE_BINARY_DIR}/report")
file(MAKE_DIRECTORY "${report_folder}/data")
set(report_sections static calculix locking dynamic stability tool cost)

# Where measure.py finds the programs, and what functions a stage has.
set(report_environment
  "INCISION_BATCH=$<TARGET_FILE:incision_batch>"
  "INCISION_REPORT=${report_folder}"
  "INCISION_OBJECTS=${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles")

function(incision_report_program program library)
  add_executable(${program} EXCLUDE_FROM_ALL ${ARGN})
  incision_compile(${program})
  set_target_properties(${program} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${report_folder}")
  target_link_libraries(${program} PRIVATE ${library} incision_findings CHOLMOD::CHOLMOD)
  target_compile_definitions(${program} PRIVATE INCISION_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  add_dependencies(report ${program})
endfunction()

foreach(section IN LISTS report_sections)
  set(folder "${PROJECT_SOURCE_DIR}/test/report/${section}")
  set(command "${folder}/measure.py")
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  if(sources)
    incision_report_program(report_${section} incision ${sources})
    if(NOT EXISTS "${folder}/measure.py")
      set(command $<TARGET_FILE:report_${section}>)
    endif()
  endif()
  add_test(NAME quick.report.${section}
    COMMAND ${command} --quick --output "${report_folder}/data/${section}.json")
  set_tests_properties(quick.report.${section} PROPERTIES
    LABELS quick TIMEOUT 600 FIXTURES_SETUP report_data ENVIRONMENT "${report_environment}")
endforeach()

# The node's part of the section `cost`, which leaves it out where there is no such program.
if(INCISION_ROS)
  incision_report_program(report_cost_markers incision_ros
    test/report/cost/ros/markers.cpp test/report/cost/cost_run.cpp)
endif()

add_test(NAME quick.report.pages
  COMMAND "${PROJECT_SOURCE_DIR}/test/report/report.py" "${report_folder}" ${report_sections})
set_tests_properties(quick.report.pages PROPERTIES LABELS quick FIXTURES_REQUIRED report_data)
