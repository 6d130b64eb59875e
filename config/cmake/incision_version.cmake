# What `git describe` says of the sources, in a header that is looked at in every build and written only where it would
# change: src/run/version.cpp alone depends on it. Without git, or in a copy that git does not track, it is the version in
# package.xml. This file is also the script that the build runs.
if(CMAKE_SCRIPT_MODE_FILE)
  set(description "${FALLBACK}")
  set(git_options --no-optional-locks -C "${SOURCE_FOLDER}")
  if(GIT)
    # Within the clone of something else git would describe that.
    execute_process(COMMAND "${GIT}" ${git_options} ls-files --error-unmatch package.xml
      RESULT_VARIABLE untracked OUTPUT_QUIET ERROR_QUIET)
    if(untracked EQUAL 0)
      execute_process(COMMAND "${GIT}" ${git_options} describe --always --dirty
        OUTPUT_VARIABLE described RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
      if(failed EQUAL 0 AND described MATCHES "^[-A-Za-z0-9._+/]+$")
        set(description "${described}")
      endif()
    endif()
  endif()
  set(text "#define INCISION_DESCRIPTION \"${description}\"\n")
  if(EXISTS "${HEADER}")
    file(READ "${HEADER}" old)
  endif()
  if(NOT text STREQUAL "${old}")
    file(WRITE "${HEADER}" "${text}")
  endif()
  return()
endif()

find_program(GIT git)
set(version_folder "${CMAKE_CURRENT_BINARY_DIR}/version")
add_custom_target(incision_version
  COMMAND "${CMAKE_COMMAND}" "-DGIT=${GIT}" "-DSOURCE_FOLDER=${PROJECT_SOURCE_DIR}" "-DFALLBACK=${INCISION_VERSION}"
    "-DHEADER=${version_folder}/incision_description.h" -P "${CMAKE_CURRENT_LIST_FILE}"
  BYPRODUCTS "${version_folder}/incision_description.h"
  VERBATIM)
set_source_files_properties(src/run/version.cpp PROPERTIES INCLUDE_DIRECTORIES "${version_folder}")
if(INCISION_NATIVE)
  set_property(SOURCE src/run/version.cpp APPEND PROPERTY COMPILE_DEFINITIONS INCISION_NATIVE)
endif()
foreach(library incision incision_v3)
  if(TARGET ${library})
    add_dependencies(${library} incision_version)
  endif()
endforeach()
