# test/fuzz/<name>_fuzzer.cpp: libFuzzer, which starts from the seeds in test/fuzz/<name>_corpus/. The target `fuzzers`
# builds them. A test fails too where the seeds reach less of the core than they should, see test/fuzz/run_fuzzer.py.
set(INCISION_FUZZ_SECONDS 20 CACHE STRING "How long ctest runs each fuzzer [s]")
add_custom_target(fuzzers)

# `least`: edges of the code that the seeds alone reach at least.
function(incision_fuzzer name least)
  set(program ${name}_fuzzer)
  add_executable(${program} EXCLUDE_FROM_ALL test/fuzz/${program}.cpp)
  incision_compile(${program})
  target_link_libraries(${program} PRIVATE incision)
  target_link_options(${program} PRIVATE -fsanitize=fuzzer)
  add_dependencies(fuzzers ${program})
  # What the fuzzer finds goes to the first folder, which is not in the source tree.
  set(found "${CMAKE_CURRENT_BINARY_DIR}/corpus/${name}")
  file(MAKE_DIRECTORY "${found}")
  add_test(NAME fuzz.${name}
    COMMAND "${PROJECT_SOURCE_DIR}/test/fuzz/run_fuzzer.py" $<TARGET_FILE:${program}> ${INCISION_FUZZ_SECONDS} ${least}
      "${found}" "${PROJECT_SOURCE_DIR}/test/fuzz/${name}_corpus")
  set_tests_properties(fuzz.${name} PROPERTIES LABELS fuzz TIMEOUT 300)
endfunction()

incision_fuzzer(mesh_reader 1500)
incision_fuzzer(scene 1400)
incision_fuzzer(state 15000)
incision_fuzzer(triangle_mesh 1800)
incision_fuzzer(urdf 900)
