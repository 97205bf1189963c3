# SPDX-License-Identifier: LGPL-2.1-or-later
# The example law, twice: the second copy is a library whose law name is taken.
foreach(copy custom_law custom_law_twice)
  add_library(test_constitutive_module_${copy} MODULE ${PROJECT_SOURCE_DIR}/examples/custom_law/fung.cc)
  set_target_properties(test_constitutive_module_${copy} PROPERTIES
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests/constitutive)
  softgrain_setup_target(test_constitutive_module_${copy})
  set_target_properties(test_constitutive_module_${copy} PROPERTIES DEFINE_SYMBOL "") # which precompiled headers do not know
  softgrain_use_precompiled_headers(test_constitutive_module_${copy} constitutive)
  target_link_libraries(test_constitutive_module_${copy} softgrain)
  add_dependencies(test_constitutive_custom_law test_constitutive_module_${copy})
endforeach()
target_compile_definitions(test_constitutive_custom_law PRIVATE
  SOFTGRAIN_CUSTOM_LAW="$<TARGET_FILE:test_constitutive_module_custom_law>"
  SOFTGRAIN_CUSTOM_LAW_TWICE="$<TARGET_FILE:test_constitutive_module_custom_law_twice>")

# Laws that are no part of softgrain: one that overflows is told so, and the tester goes on to its end; one that dissipates
# and one that gives its energy alone hold every property.
set(laws overflowing dissipative)
if(DEAL_II_TRILINOS_WITH_SACADO)
  list(APPEND laws energy_only)
endif()
foreach(law ${laws})
  add_library(test_constitutive_module_${law} MODULE ${CMAKE_CURRENT_SOURCE_DIR}/constitutive/modules/${law}.cc)
  set_target_properties(test_constitutive_module_${law} PROPERTIES
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests/constitutive)
  softgrain_setup_target(test_constitutive_module_${law})
  set_target_properties(test_constitutive_module_${law} PROPERTIES DEFINE_SYMBOL "") # which precompiled headers do not know
  softgrain_use_precompiled_headers(test_constitutive_module_${law} constitutive)
  target_link_libraries(test_constitutive_module_${law} softgrain)
  add_dependencies(softgrain_law_tester test_constitutive_module_${law})
  add_test(NAME constitutive/${law}_law
    COMMAND softgrain_law_tester $<TARGET_FILE:test_constitutive_module_${law}>)
  set_tests_properties(constitutive/${law}_law PROPERTIES LABELS "quick;constitutive" TIMEOUT ${SOFTGRAIN_TEST_TIMEOUT})
endforeach()
set_tests_properties(constitutive/overflowing_law PROPERTIES
  PASS_REGULAR_EXPRESSION
    "FAILED: no overflow, division by zero or undefined number on the way.*every law holds every property: no")

# The example as a user builds it, by its own CMakeLists.txt; slower, so not among the quick ones.
add_test(NAME constitutive/custom_law_alone
  COMMAND ${CMAKE_CTEST_COMMAND}
    --build-and-test ${PROJECT_SOURCE_DIR}/examples/custom_law ${CMAKE_BINARY_DIR}/tests/constitutive/custom_law_alone
    --build-generator ${CMAKE_GENERATOR}
    --build-options -DSOFTGRAIN_DIR=${CMAKE_BINARY_DIR} -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}
      -DDEAL_II_DIR=${deal.II_DIR}
    --test-command $<TARGET_FILE:softgrain_law_tester>
      ${CMAKE_BINARY_DIR}/tests/constitutive/custom_law_alone/libcustom_law.so)
set_tests_properties(constitutive/custom_law_alone PROPERTIES LABELS "full;constitutive" TIMEOUT 600)

# Cost of a law per point; fails only when far above what it should be, because machines are shared.
add_executable(test_constitutive_law_cost ${CMAKE_CURRENT_SOURCE_DIR}/constitutive/performance/law_cost.cc)
softgrain_setup_target(test_constitutive_law_cost)
softgrain_use_precompiled_headers(test_constitutive_law_cost constitutive)
target_link_libraries(test_constitutive_law_cost softgrain)
set_target_properties(test_constitutive_law_cost PROPERTIES
  RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests/constitutive)
add_test(NAME constitutive/law_cost COMMAND test_constitutive_law_cost)
set_tests_properties(constitutive/law_cost PROPERTIES LABELS "performance;constitutive" TIMEOUT 300)
