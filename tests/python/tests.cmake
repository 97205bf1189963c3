# SPDX-License-Identifier: LGPL-2.1-or-later
# The Python package on a short run: the examples of its pages, its arrays against measures.csv, films, conversions.
if(TARGET softgrain_executable AND EXISTS ${PROJECT_SOURCE_DIR}/source/mpm)
  set(example ${CMAKE_BINARY_DIR}/tests/python/example.run)
  add_test(NAME python/example
    COMMAND ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/python/example.py ${PROJECT_SOURCE_DIR}/python
      ${CMAKE_BINARY_DIR}/tests/python/example.work ${example} $<TARGET_FILE:softgrain_executable>)
  set_tests_properties(python/example PROPERTIES FIXTURES_SETUP python_example)
  foreach(name doctests states space programs sweeps scenes pictures report study hostile verdict)
    add_test(NAME python/${name}
      COMMAND ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/python/${name}.py
        ${PROJECT_SOURCE_DIR}/python ${CMAKE_BINARY_DIR}/tests/python/${name}.run ${example}
        $<TARGET_FILE:softgrain_executable>)
    set_tests_properties(python/${name} PROPERTIES FIXTURES_REQUIRED python_example)
  endforeach()
  set_tests_properties(python/example python/doctests python/states python/space python/programs python/sweeps python/scenes python/pictures
    python/report python/study python/hostile python/verdict PROPERTIES
    LABELS "quick;python" TIMEOUT ${SOFTGRAIN_TEST_TIMEOUT})

  add_test(NAME python/notebook
    COMMAND ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/python/notebook.py
      ${PROJECT_SOURCE_DIR}/python ${CMAKE_BINARY_DIR}/tests/python/notebook.run ${example}
      $<TARGET_FILE:softgrain_executable>)
  set_tests_properties(python/notebook PROPERTIES LABELS "nightly;python" TIMEOUT 3600)
endif()

add_test(NAME python/rivals
  COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/python/rivals.py
    ${CMAKE_BINARY_DIR}/tests/python/rivals.run)
set_tests_properties(python/rivals PROPERTIES LABELS "quick;python" TIMEOUT ${SOFTGRAIN_TEST_TIMEOUT})
