# SPDX-License-Identifier: LGPL-2.1-or-later
# One member of every family of replaceable parts, each in a library of its own.
file(GLOB modules CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/extensions/modules/*.cc)
set(libraries "")
foreach(module ${modules})
  get_filename_component(name ${module} NAME_WE)
  add_library(test_extensions_${name} MODULE ${module})
  set_target_properties(test_extensions_${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests/extensions)
  softgrain_setup_target(test_extensions_${name})
  set_target_properties(test_extensions_${name} PROPERTIES DEFINE_SYMBOL "") # which precompiled headers do not know
  softgrain_use_precompiled_headers(test_extensions_${name} mpm)
  target_link_libraries(test_extensions_${name} softgrain)
  list(APPEND libraries $<TARGET_FILE:test_extensions_${name}>)
endforeach()
list(JOIN libraries "," libraries)
add_test(NAME extensions/one_of_each
  COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1
    ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/extensions/one_of_each.py $<TARGET_FILE:softgrain_executable>
    ${PROJECT_SOURCE_DIR} ${CMAKE_BINARY_DIR}/tests/extensions/run ${libraries})
set_tests_properties(extensions/one_of_each PROPERTIES LABELS "quick;extensions" TIMEOUT ${SOFTGRAIN_TEST_TIMEOUT})
