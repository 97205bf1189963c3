# SPDX-License-Identifier: LGPL-2.1-or-later
# The Python tools on the folders that output/synthetic_run leaves.
set_tests_properties(output/synthetic_run PROPERTIES FIXTURES_SETUP synthetic_output)
add_test(NAME output/tools
  COMMAND ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/output/tools.py
    ${PROJECT_SOURCE_DIR}/python ${CMAKE_BINARY_DIR}/tests/output/synthetic_run.run
    ${CMAKE_BINARY_DIR}/tests/output/tools.run)
set_tests_properties(output/tools PROPERTIES LABELS "quick;output" TIMEOUT ${SOFTGRAIN_TEST_TIMEOUT}
  FIXTURES_REQUIRED synthetic_output)

# The same tools on folders that the tests make up.
foreach(name primaries one_grain)
  add_test(NAME output/${name}
    COMMAND ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/output/${name}.py
      ${PROJECT_SOURCE_DIR}/python ${CMAKE_BINARY_DIR}/tests/output/${name}.run)
  set_tests_properties(output/${name} PROPERTIES LABELS "quick;output" TIMEOUT ${SOFTGRAIN_TEST_TIMEOUT})
endforeach()
