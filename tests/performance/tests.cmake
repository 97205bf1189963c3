# SPDX-License-Identifier: LGPL-2.1-or-later
# Programs that measure times; nothing is compared, because other work on the machine changes the figures.
# ninja -C build/release disk_solver_benchmark && build/release/tests/performance/disk_solver_benchmark PACKING

add_executable(disk_solver_benchmark EXCLUDE_FROM_ALL ${CMAKE_CURRENT_SOURCE_DIR}/performance/disk_solver.cc)
set_target_properties(disk_solver_benchmark PROPERTIES
  RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests/performance)
softgrain_setup_target(disk_solver_benchmark)
target_link_libraries(disk_solver_benchmark softgrain)
