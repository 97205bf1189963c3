# SPDX-License-Identifier: LGPL-2.1-or-later
# Right values of whole runs. Those in 'owed' are known to be wrong; their tests fail as soon as they are right, or wrong in
# another way than is known (see value_test.py).
add_test(NAME values/value_test_fails
  COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 ${SOFTGRAIN_PYTHON}
    ${CMAKE_CURRENT_SOURCE_DIR}/values/value_test_fails.py ${CMAKE_BINARY_DIR}/tests/values/value_test_fails.run)
set_tests_properties(values/value_test_fails PROPERTIES LABELS "quick;values" TIMEOUT ${SOFTGRAIN_TEST_TIMEOUT})

if(TARGET softgrain_executable AND EXISTS ${PROJECT_SOURCE_DIR}/source/mpm)
  file(GLOB cases RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/values CONFIGURE_DEPENDS
    ${CMAKE_CURRENT_SOURCE_DIR}/values/owed/*.py ${CMAKE_CURRENT_SOURCE_DIR}/values/held/*.py)
  foreach(case ${cases})
    string(REGEX REPLACE "\\.py$" "" name ${case})
    add_test(NAME values/${name}
      COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 ${SOFTGRAIN_PYTHON}
        ${CMAKE_CURRENT_SOURCE_DIR}/values/value_test.py $<TARGET_FILE:softgrain_executable>
        ${CMAKE_BINARY_DIR}/tests/values/${name}.run ${CMAKE_CURRENT_SOURCE_DIR}/values/${case})
    # Whole packings take too long to be waited for.
    set(label quick)
    if(name STREQUAL "held/polygons_at_rest")
      set(label nightly)
    endif()
    set_tests_properties(values/${name} PROPERTIES LABELS "${label};values" TIMEOUT ${SOFTGRAIN_TEST_TIMEOUT})
  endforeach()
endif()
