# SPDX-License-Identifier: LGPL-2.1-or-later
# The figures of the thesis on runs made up from its own laws.
add_test(NAME analysis/figures
  COMMAND ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/analysis/figures.py
    ${PROJECT_SOURCE_DIR}/python ${CMAKE_BINARY_DIR}/tests/analysis/figures.run)
set_tests_properties(analysis/figures PROPERTIES LABELS "quick;analysis" TIMEOUT ${SOFTGRAIN_TEST_TIMEOUT})

add_test(NAME analysis/figures_paths
  COMMAND ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/analysis/figures_paths.py
    ${PROJECT_SOURCE_DIR}/python ${CMAKE_BINARY_DIR}/tests/analysis/figures_paths.run)
set_tests_properties(analysis/figures_paths PROPERTIES LABELS "quick;analysis" TIMEOUT ${SOFTGRAIN_TEST_TIMEOUT})
