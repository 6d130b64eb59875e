# The core's parallel parts under the thread sanitizer: the parallel loop alone, and scenes on four threads that
# together go through assembly, both solvers, cuts, contact, fracture and a tool; and two bodies at once. The target
# `thread_tests` builds what they need.
add_custom_target(thread_tests DEPENDS incision_base_tests incision_batch)

function(incision_thread_test name)
  add_test(NAME threads.${name} COMMAND ${ARGN})
  set_tests_properties(threads.${name} PROPERTIES LABELS threads TIMEOUT 300)
endfunction()

function(incision_thread_scene name scene steps)
  incision_thread_test(${name} incision_batch "${PROJECT_SOURCE_DIR}/${scene}" --threads 4 --steps ${steps} ${ARGN})
endfunction()

incision_thread_test(parallel incision_base_tests --gtest_filter=Parallel*)
incision_thread_scene(direct config/scenes/movement_independence.yaml 5)
incision_thread_scene(cuts config/scenes/crossing_cuts.yaml 10 --set solver.method=iterative)
incision_thread_scene(contact config/scenes/dropped_plate.yaml 20)
incision_thread_scene(fracture config/scenes/slit_plane.yaml 20
  --set fracture.tensile_strength=1000 --set fracture.fuse_distance=0.02)
incision_thread_scene(tool test/ros/tool_bar.yaml 40 --set solver.method=iterative
  --set tools.tool.poses=[[0,0.51,-0.05,0,0,0,0,1],[0.35,0.51,0.3,0,0,0,0,1]])
incision_test_program(incision_two_bodies_tests incision thread_tests test/body/two_bodies_test.cpp)
incision_thread_test(bodies incision_two_bodies_tests)
