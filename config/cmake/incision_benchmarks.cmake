# Benchmarks in test/benchmark/, with INCISION_BENCHMARK; the target `benchmarks` builds them.
# - kernels_benchmark: Google Benchmark, the pieces of a step.
# - step_benchmark: whole steps, beside a plain reference and Bullet.
find_package(benchmark REQUIRED)
find_package(Bullet REQUIRED)

add_custom_target(benchmarks)

function(incision_benchmark name)
  add_executable(${name} EXCLUDE_FROM_ALL ${ARGN})
  incision_compile(${name})
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}/test")
  target_link_libraries(${name} PRIVATE incision)
  add_dependencies(benchmarks ${name})
endfunction()

incision_benchmark(kernels_benchmark test/benchmark/kernels_benchmark.cpp test/benchmark/triad.cpp)
target_link_libraries(kernels_benchmark PRIVATE benchmark::benchmark)

file(GLOB step_sources CONFIGURE_DEPENDS test/benchmark/*.cpp)
list(REMOVE_ITEM step_sources
  "${PROJECT_SOURCE_DIR}/test/benchmark/kernels_benchmark.cpp" "${PROJECT_SOURCE_DIR}/test/benchmark/triad.cpp")
incision_benchmark(step_benchmark ${step_sources})
target_compile_definitions(step_benchmark PRIVATE INCISION_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
# What FindBullet finds is the build in single precision, Bullet's default and the quicker one; the headers take it so
# as long as BT_USE_DOUBLE_PRECISION is not defined.
target_include_directories(step_benchmark SYSTEM PRIVATE ${BULLET_INCLUDE_DIRS})
target_link_libraries(step_benchmark PRIVATE
  ${BULLET_LIBRARIES} CHOLMOD::CHOLMOD OpenMP::OpenMP_CXX nlohmann_json::nlohmann_json)
# Bullet's headers copy members that its constructors leave open.
set_source_files_properties(test/benchmark/bullet_body.cpp PROPERTIES COMPILE_OPTIONS -Wno-maybe-uninitialized)
