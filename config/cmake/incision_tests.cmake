# Tests, all run by ctest. The target `tests` builds the quick ones, `full_tests` the slow ones of GoogleTest.
# Each has one label, which its name begins with:
# - quick: what test/run.sh runs by itself, some minutes on two cores. A test that takes 20 s or more is not quick.
# - full: the slow ones. Of GoogleTest these are the tests whose suite or name starts with "Full" and all of
#   *_full_test.cpp; of rostest *_full.test.
# - realtime: the verdict depends on how busy the machine is, so these run one at a time: *_realtime.test,
#   *_realtime_test.py.
# - report: the report's claims, see incision_report.
# - fuzz: with INCISION_FUZZ, see incision_fuzzers.
# - threads: with INCISION_SANITIZE=thread, see incision_threads.
#
# Where they lie:
# - test/<stage>/*_test.cpp: GoogleTest, one program a stage. *_alloc_test.cpp replace malloc, so they are a program
#   apart. Some stages run on other arithmetic too, see incision_on_processors.
# - test/body/instruction_count.py: instructions a step, where valgrind is installed.
# - test/ros/*.test: rostest.
# - test/run/version_test.py: what the build writes down as the version.
# - test/study/*_test.py: studies of many runs; *_full_test.py are slow, most start servers.
# - test/install/: a program against the installed package.
# - test/pages/: the pages of documentation.
# - the sources: what includes what, their format, catkin_lint.
if(INCISION_ROS AND NOT CATKIN_ENABLE_TESTING)
  return()
endif()
enable_testing()
if(NOT TARGET tests)
  add_custom_target(tests)
endif()
add_custom_target(full_tests)

if(NOT TARGET GTest::gtest_main)
  find_package(GTest REQUIRED)
endif()
include(GoogleTest)

function(incision_discover target label filter)
  gtest_discover_tests(${target}
    TEST_PREFIX "${label}." NO_PRETTY_VALUES TEST_FILTER "${filter}" DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS ${label} TIMEOUT 900)
endfunction()

# One program from the given files, linked with a library of ours; the target `group` builds it.
function(incision_test_program name library group)
  add_executable(${name} EXCLUDE_FROM_ALL ${ARGN})
  incision_compile(${name})
  incision_unite(${name})
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}/test")
  target_link_libraries(${name} PRIVATE ${library} CHOLMOD::CHOLMOD cereal::cereal nlohmann_json::nlohmann_json GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE
    INCISION_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    $<$<TARGET_EXISTS:incision_v3>:INCISION_V3>)
  if(INCISION_SANITIZE)
    target_compile_definitions(${name} PRIVATE INCISION_SANITIZE)
  endif()
  # What is to be quick is the core. Tests themselves compile in two thirds of the time so.
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  if(name STREQUAL "incision_base_tests")
    target_precompile_headers(${name} PRIVATE <gtest/gtest.h> ${INCISION_COMMON_HEADERS})
  else()
    target_precompile_headers(${name} REUSE_FROM incision_base_tests)
  endif()
  add_dependencies(${group} ${name})
endfunction()

function(incision_stage_tests stage library)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS test/${stage}/*_test.cpp)
  file(GLOB full_files CONFIGURE_DEPENDS test/${stage}/*_full_test.cpp)
  file(GLOB alloc_files CONFIGURE_DEPENDS test/${stage}/*_alloc_test.cpp)
  list(REMOVE_ITEM files ${full_files} ${alloc_files})
  if(files)
    incision_test_program(incision_${stage}_tests ${library} tests ${files})
    incision_discover(incision_${stage}_tests quick "-Full*:*.Full*")
    incision_discover(incision_${stage}_tests full "Full*:*.Full*")
  endif()
  if(full_files)
    incision_test_program(incision_${stage}_full_tests ${library} full_tests ${full_files})
    incision_discover(incision_${stage}_full_tests full "*")
  endif()
  if(alloc_files)
    incision_test_program(incision_${stage}_alloc_tests ${library} tests ${alloc_files})
    incision_discover(incision_${stage}_alloc_tests quick "-Full*:*.Full*")
    incision_discover(incision_${stage}_alloc_tests full "Full*:*.Full*")
  endif()
endfunction()

foreach(stage IN LISTS STAGES)
  incision_stage_tests(${stage} incision)
endforeach()
# Some of these run the program.
add_dependencies(incision_run_tests incision_batch)
if(INCISION_ROS)
  incision_stage_tests(ros incision_ros)
  include(incision_rostests)
endif()
if(TARGET incision_v3)
  include(incision_processors)
endif()

if(INCISION_ROS AND NOT INCISION_SANITIZE)
  add_test(NAME quick.install COMMAND "${PROJECT_SOURCE_DIR}/test/install/install_test.py" "${CMAKE_BINARY_DIR}")
  set_tests_properties(quick.install PROPERTIES LABELS quick TIMEOUT 300)
endif()

# The pages of documentation: their links, and the command lines in them.
if(INCISION_ROS AND NOT INCISION_SANITIZE)
  set(commands_classes Coverage WithoutRos InTheNode OwnOrgan Checkpoints)
  set(tables_classes WithoutRos InTheNode)
  foreach(what IN ITEMS commands tables)
    foreach(class IN LISTS ${what}_classes)
      add_test(NAME quick.pages.${what}.${class}
        COMMAND "${PROJECT_SOURCE_DIR}/test/pages/${what}_test.py" "${CMAKE_BINARY_DIR}" ${class})
      set_tests_properties(quick.pages.${what}.${class} PROPERTIES LABELS quick TIMEOUT 300)
    endforeach()
  endforeach()
  add_test(NAME full.pages.commands COMMAND "${PROJECT_SOURCE_DIR}/test/pages/commands_full_test.py" "${CMAKE_BINARY_DIR}")
  set_tests_properties(full.pages.commands PROPERTIES LABELS full TIMEOUT 3600)
endif()

add_test(NAME quick.run.version
  COMMAND "${PROJECT_SOURCE_DIR}/test/run/version_test.py" "${CMAKE_COMMAND}")
set_tests_properties(quick.run.version PROPERTIES LABELS quick TIMEOUT 60)

if(INCISION_ROS AND NOT INCISION_SANITIZE)
  file(GLOB study_tests CONFIGURE_DEPENDS test/study/*_test.py)
  foreach(file IN LISTS study_tests)
    get_filename_component(name ${file} NAME_WE)
    string(REGEX REPLACE "_test$" "" name ${name})
    set(label quick)
    if(name MATCHES "_(full|realtime)$")
      set(label ${CMAKE_MATCH_1})
    endif()
    add_test(NAME ${label}.study.${name} COMMAND ${file})
    set_tests_properties(${label}.study.${name} PROPERTIES
      LABELS ${label} TIMEOUT 300
      ENVIRONMENT "INCISION_BATCH=$<TARGET_FILE:incision_batch>;INCISION_BUILD=${CMAKE_BINARY_DIR}")
    if(label STREQUAL "realtime")
      set_tests_properties(${label}.study.${name} PROPERTIES RUN_SERIAL ON)
    endif()
  endforeach()
endif()

# Instruction counts hold for the compiler and the flags they were counted with.
find_program(VALGRIND valgrind)
if(VALGRIND AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU"
    AND CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT INCISION_NATIVE AND NOT INCISION_SANITIZE)
  add_test(NAME quick.cost.instructions
    COMMAND "${PROJECT_SOURCE_DIR}/test/body/instruction_count.py" $<TARGET_FILE:incision_batch> ${VALGRIND})
  set_tests_properties(quick.cost.instructions PROPERTIES LABELS quick TIMEOUT 300)
endif()

# The sanitizers would take an hour, and the other tests cover the same code under them.
if(NOT INCISION_SANITIZE)
  include(incision_report)
endif()

# Checks of the sources, of which a program that is not installed drops out.
function(incision_source_check name program)
  if(${program})
    add_test(NAME quick.sources.${name} COMMAND ${${program}} ${ARGN} WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
    set_tests_properties(quick.sources.${name} PROPERTIES LABELS quick)
  endif()
endfunction()

if(INCISION_ROS)
  find_program(CLANG_FORMAT clang-format-14)
  find_program(CATKIN_LINT catkin_lint)
  file(GLOB_RECURSE formatted CONFIGURE_DEPENDS include/*.h src/*.h src/*.cpp test/*.h test/*.cpp)
  incision_source_check(shape PYTHON_EXECUTABLE test/check_sources.py)
  incision_source_check(pages PYTHON_EXECUTABLE test/pages/pages_test.py)
  incision_source_check(format CLANG_FORMAT --dry-run -Werror ${formatted})
  incision_source_check(catkin_lint CATKIN_LINT -W1 --strict --ignore package_path_name .)
endif()

if(INCISION_FUZZ)
  include(incision_fuzzers)
endif()
if(INCISION_SANITIZE STREQUAL "thread")
  include(incision_threads)
endif()
