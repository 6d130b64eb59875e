# How our own targets are compiled: optimised unless asked otherwise, with warnings.
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

# A fuzzer sees the counters of what is linked into it, and none of a shared library's.
set(BUILD_SHARED_LIBS ON)
if(INCISION_FUZZ)
  set(BUILD_SHARED_LIBS OFF)
endif()

add_library(incision_flags INTERFACE)
target_compile_features(incision_flags INTERFACE cxx_std_17)
# No semantic interposition: calls within a shared library need not allow for another library replacing them.
target_compile_options(incision_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -fno-semantic-interposition
  $<$<BOOL:${INCISION_WERROR}>:-Werror>)

# These change the layout of Eigen's types or what is linked, so they hold for every target, not only for ours.
include(incision-extras)
if(INCISION_NATIVE)
  add_compile_options(-march=native)
endif()
if(INCISION_SANITIZE)
  add_compile_options(-fsanitize=${INCISION_SANITIZE} -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${INCISION_SANITIZE})
endif()
if(INCISION_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# Calls into libraries are bound at loading, not one by one in the step that first needs them: a cut's, mostly.
target_link_options(incision_flags INTERFACE -Wl,-z,now)

# What is linked with a shared library need not be linked again because that has changed inside.
set(CMAKE_LINK_DEPENDS_NO_SHARED ON)

function(incision_compile target)
  set_target_properties(${target} PROPERTIES CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:incision_flags>)
endfunction()

# What a folder's files have in common, most of what they include, is compiled once: together they are one unit, which
# takes less than half the time. With CMAKE_UNITY_BUILD OFF each file is a unit of its own. The build of the thread
# sanitizer is such: there one that includes too little is found.
function(incision_unite target)
  if(DEFINED CMAKE_UNITY_BUILD AND NOT CMAKE_UNITY_BUILD)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(path "${source}" ABSOLUTE)
    get_filename_component(folder "${path}" DIRECTORY)
    file(RELATIVE_PATH folder "${PROJECT_SOURCE_DIR}" "${folder}")
    string(MAKE_C_IDENTIFIER "${folder}" group)
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP ${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# Headers of others that nearly every file of ours includes: read once, they save up to a third of the time that
# compiling takes. ccache keeps no results of what is compiled so.
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache")
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()
set(INCISION_COMMON_HEADERS <Eigen/Dense> <algorithm> <functional> <memory> <string> <unordered_map> <vector>)
