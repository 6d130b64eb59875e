# Tests, all run by ctest and labelled `quick` or `full`; the target `tests` builds them.
# - test/<stage>/*_test.cpp: GoogleTest, one program a stage. Full are the tests whose suite or name starts with
#   "Full" and all of *_full_test.cpp. *_alloc_test.cpp replace malloc, so they are a program apart.
# - test/body/instruction_count.py: instructions a step, where valgrind is installed.
# - test/ros/*.test: rostest. Full are *_full.test.
# - test/install/: a program against the installed package.
# - the sources: what includes what, their format, catkin_lint.
# - test/report/<section>/: the report's claims, see incision_report.
# - test/fuzz/<name>_fuzzer.cpp: libFuzzer, with INCISION_FUZZ; starts from the seeds in test/fuzz/<name>_corpus/.
if(INCISION_ROS AND NOT CATKIN_ENABLE_TESTING)
  return()
endif()
enable_testing()
if(NOT TARGET tests)
  add_custom_target(tests)
endif()

if(NOT TARGET GTest::gtest_main)
  find_package(GTest REQUIRED)
endif()
include(GoogleTest)

function(incision_discover target label filter)
  gtest_discover_tests(${target}
    TEST_PREFIX "${label}." NO_PRETTY_VALUES TEST_FILTER "${filter}" DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS ${label} TIMEOUT 900)
endfunction()

# One program from the given files, linked with a library of ours.
function(incision_test_program name library)
  add_executable(${name} EXCLUDE_FROM_ALL ${ARGN})
  incision_compile(${name})
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}/test")
  target_link_libraries(${name} PRIVATE ${library} CHOLMOD::CHOLMOD nlohmann_json::nlohmann_json GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE
    INCISION_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    $<$<BOOL:${INCISION_SANITIZE}>:INCISION_SANITIZE>
    $<$<TARGET_EXISTS:incision_v3>:INCISION_V3>)
  add_dependencies(tests ${name})
endfunction()

function(incision_stage_tests stage library)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS test/${stage}/*_test.cpp)
  file(GLOB full_files CONFIGURE_DEPENDS test/${stage}/*_full_test.cpp)
  file(GLOB alloc_files CONFIGURE_DEPENDS test/${stage}/*_alloc_test.cpp)
  list(REMOVE_ITEM files ${full_files} ${alloc_files})
  if(files)
    incision_test_program(incision_${stage}_tests ${library} ${files})
    incision_discover(incision_${stage}_tests quick "-Full*:*.Full*")
    incision_discover(incision_${stage}_tests full "Full*:*.Full*")
  endif()
  if(full_files)
    incision_test_program(incision_${stage}_full_tests ${library} ${full_files})
    incision_discover(incision_${stage}_full_tests full "*")
  endif()
  if(alloc_files)
    incision_test_program(incision_${stage}_alloc_tests ${library} ${alloc_files})
    incision_discover(incision_${stage}_alloc_tests quick "*")
  endif()
endfunction()

foreach(stage IN LISTS STAGES)
  incision_stage_tests(${stage} incision)
endforeach()

if(INCISION_ROS)
  incision_stage_tests(ros incision_ros)
  file(GLOB rostests CONFIGURE_DEPENDS test/ros/*.test)
  foreach(file IN LISTS rostests)
    get_filename_component(name ${file} NAME_WE)
    set(label quick)
    if(name MATCHES "_full$")
      set(label full)
    endif()
    add_test(NAME ${label}.ros.${name} COMMAND "${CATKIN_DEVEL_PREFIX}/env.sh" rostest ${file})
    set_tests_properties(${label}.ros.${name} PROPERTIES
      LABELS ${label} RUN_SERIAL ON TIMEOUT 300
      ENVIRONMENT "ROS_IP=127.0.0.1;ROS_HOME=${CMAKE_CURRENT_BINARY_DIR}/ros_home")
  endforeach()
endif()

if(INCISION_ROS AND NOT INCISION_SANITIZE)
  add_test(NAME quick.install COMMAND "${PROJECT_SOURCE_DIR}/test/install/install_test.py" "${CMAKE_BINARY_DIR}")
  set_tests_properties(quick.install PROPERTIES LABELS quick TIMEOUT 300)
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
  incision_source_check(format CLANG_FORMAT --dry-run -Werror ${formatted})
  incision_source_check(catkin_lint CATKIN_LINT -W1 --strict --ignore package_path_name .)
endif()

if(INCISION_FUZZ)
  set(INCISION_FUZZ_SECONDS 20 CACHE STRING "How long ctest runs each fuzzer [s]")
  file(GLOB fuzzers CONFIGURE_DEPENDS test/fuzz/*_fuzzer.cpp)
  foreach(file IN LISTS fuzzers)
    get_filename_component(program ${file} NAME_WE)
    string(REGEX REPLACE "_fuzzer$" "" name ${program})
    add_executable(${program} EXCLUDE_FROM_ALL ${file})
    incision_compile(${program})
    target_link_libraries(${program} PRIVATE incision)
    target_link_options(${program} PRIVATE -fsanitize=fuzzer)
    add_dependencies(tests ${program})
    # What the fuzzer finds goes to the first folder, which is not in the source tree.
    file(MAKE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/corpus/${name}")
    add_test(NAME quick.fuzz.${name}
      COMMAND ${program} -max_total_time=${INCISION_FUZZ_SECONDS} -timeout=10 -rss_limit_mb=2048 -print_final_stats=1
        corpus/${name} "${PROJECT_SOURCE_DIR}/test/fuzz/${name}_corpus")
    set_tests_properties(quick.fuzz.${name} PROPERTIES LABELS quick TIMEOUT 300)
  endforeach()
endif()
