# The report: what test/report/<section>/ measures, its claims, and the pages. ctest builds the target `report`, which is
# no part of `tests`, measures each section quickly, as a fixture of the tests in <section>/claims.py, and draws the pages.
add_custom_target(report DEPENDS incision_batch)

add_library(incision_report STATIC EXCLUDE_FROM_ALL test/report/section.cpp)
incision_compile(incision_report)
target_include_directories(incision_report PUBLIC "${PROJECT_SOURCE_DIR}/test")
target_link_libraries(incision_report PUBLIC nlohmann_json::nlohmann_json)

set(report_sources "${PROJECT_SOURCE_DIR}/test/report")
set(report_folder "${CMAKE_BINARY_DIR}/report")
set(report_sections static calculix benchmark locking regions dynamic contact stability tool cost)

function(incision_report_program program library)
  add_executable(${program} EXCLUDE_FROM_ALL ${ARGN})
  incision_compile(${program})
  set_target_properties(${program} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${report_folder}")
  target_link_libraries(${program} PRIVATE ${library} incision_report CHOLMOD::CHOLMOD)
  target_compile_definitions(${program} PRIVATE INCISION_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  add_dependencies(report ${program})
endfunction()

function(incision_report_test name)
  cmake_parse_arguments(PARSE_ARGV 1 test "" "SETS_UP" "COMMAND;NEEDS")
  add_test(NAME report.${name} COMMAND ${test_COMMAND} WORKING_DIRECTORY "${report_sources}")
  set_tests_properties(report.${name} PROPERTIES
    LABELS report TIMEOUT 900 FIXTURES_SETUP "${test_SETS_UP}" FIXTURES_REQUIRED "${test_NEEDS}"
    ENVIRONMENT "INCISION_BATCH=$<TARGET_FILE:incision_batch>;INCISION_PROGRAMS=${report_folder};INCISION_REPORT=${report_folder}/quick")
endfunction()

cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
incision_report_test(build SETS_UP report_programs
  COMMAND "${CMAKE_COMMAND}" --build "${CMAKE_BINARY_DIR}" --target report --parallel ${cores})

foreach(section IN LISTS report_sections)
  file(GLOB sources CONFIGURE_DEPENDS ${report_sources}/${section}/*.cpp)
  if(sources)
    incision_report_program(report_${section} incision ${sources})
  endif()
  incision_report_test(${section}.measure SETS_UP report_${section} NEEDS report_programs
    COMMAND "${report_sources}/measure.py" --quick "${report_folder}/quick" ${section})

  set(file "${report_sources}/${section}/claims.py")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  file(STRINGS "${file}" lines REGEX "^(class|    def test_)" ENCODING UTF-8)
  foreach(line IN LISTS lines)
    if(line MATCHES "^class ([A-Za-z]+)")
      set(class ${CMAKE_MATCH_1})
    elseif(line MATCHES "def test_([a-z0-9_]+)")
      incision_report_test(${section}.${CMAKE_MATCH_1} NEEDS report_${section}
        COMMAND /usr/bin/python3 -m unittest ${section}.claims.${class}.test_${CMAKE_MATCH_1})
    endif()
  endforeach()
endforeach()

# The node's part of the section `cost`, which leaves it out where there is no such program.
if(INCISION_ROS)
  incision_report_program(report_cost_markers incision_ros
    test/report/cost/ros/markers.cpp test/report/cost/cost_run.cpp)
endif()

list(TRANSFORM report_sections PREPEND report_ OUTPUT_VARIABLE report_fixtures)
incision_report_test(pages NEEDS ${report_fixtures}
  COMMAND "${report_sources}/report.py" "${report_folder}/quick" ${report_sections})
