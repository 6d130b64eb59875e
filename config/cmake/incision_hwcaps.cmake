# The core once more, for processors with AVX2 and FMA: in a folder beside the plain one, where the dynamic loader
# (glibc 2.33 or later) looks first when the processor has them. Programs link the plain one and need not know.
set(hwcaps glibc-hwcaps/x86-64-v3)
set(core_folder "${CMAKE_CURRENT_BINARY_DIR}")
if(CMAKE_LIBRARY_OUTPUT_DIRECTORY)
  set(core_folder "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
endif()

include(CheckCXXCompilerFlag)
check_cxx_compiler_flag(-march=x86-64-v3 INCISION_KNOWS_V3)
if(NOT INCISION_KNOWS_V3 OR INCISION_NATIVE OR INCISION_SANITIZE OR INCISION_FUZZ)
  # The loader would still find what an earlier configuration has left there.
  file(REMOVE_RECURSE "${core_folder}/${hwcaps}")
  return()
endif()

add_library(incision_v3 ${core_sources})
incision_compile(incision_v3)
incision_unite(incision_v3)
target_precompile_headers(incision_v3 PRIVATE ${INCISION_COMMON_HEADERS})
foreach(property INCLUDE_DIRECTORIES LINK_LIBRARIES)
  get_target_property(value incision ${property})
  set_property(TARGET incision_v3 PROPERTY ${property} "${value}")
endforeach()
target_compile_options(incision_v3 PRIVATE -march=x86-64-v3)
# Templates that programs instantiate too stay the library's own, not the programs' plain ones.
target_link_options(incision_v3 PRIVATE -Wl,-Bsymbolic-functions)
set_target_properties(incision_v3 PROPERTIES
  OUTPUT_NAME incision LIBRARY_OUTPUT_DIRECTORY "${core_folder}/${hwcaps}")
# A program must not start with one that is out of date.
add_dependencies(incision incision_v3)
if(INCISION_ROS)
  install(TARGETS incision_v3 LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}/${hwcaps})
endif()
