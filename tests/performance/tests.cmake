# SPDX-License-Identifier: LGPL-2.1-or-later
# Programs that measure times; nothing is compared, because other work on the machine changes the figures.
# ninja -C build/release disk_solver_benchmark && build/release/tests/performance/disk_solver_benchmark PACKING
# ninja -C build/release contact_solver_benchmark && build/release/tests/performance/contact_solver_benchmark PROBLEM.h5…
# ninja -C build/release path_following_benchmark && build/release/tests/performance/path_following_benchmark PROBLEM.h5…

foreach(name disk_solver contact_solver path_following)
  set(program ${name}_benchmark)
  add_executable(${program} EXCLUDE_FROM_ALL ${CMAKE_CURRENT_SOURCE_DIR}/performance/${name}.cc)
  set_target_properties(${program} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests/performance)
  softgrain_setup_target(${program})
  target_link_libraries(${program} softgrain)
endforeach()
