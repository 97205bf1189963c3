# SPDX-License-Identifier: LGPL-2.1-or-later
# The house keeps itself in order: every check of contrib/checks on the sources, and on samples that it must refuse.
if(NOT SOFTGRAIN_PYTHON)
  message(FATAL_ERROR "the checks of contrib/checks need python3")
endif()

function(softgrain_add_house_test name label)
  add_test(NAME house/${name} COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 ${ARGN}
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  set_tests_properties(house/${name} PROPERTIES LABELS "${label};house" TIMEOUT 300)
endfunction()

foreach(check include_direction formatting file_heads leftovers documentation plain_words tests scripts)
  softgrain_add_house_test(${check} quick
    ${SOFTGRAIN_PYTHON} ${PROJECT_SOURCE_DIR}/contrib/checks/${check}.py)
  softgrain_add_house_test(${check}_refuses quick
    ${SOFTGRAIN_PYTHON} ${PROJECT_SOURCE_DIR}/tests/house/bad_samples.py ${check})
endforeach()

softgrain_add_house_test(python_types nightly ${SOFTGRAIN_PYTHON} ${PROJECT_SOURCE_DIR}/contrib/checks/python_types.py)
softgrain_add_house_test(python_types_refuses nightly
  ${SOFTGRAIN_PYTHON} ${PROJECT_SOURCE_DIR}/tests/house/bad_samples.py python_types)

softgrain_add_house_test(quickstart quick ${SOFTGRAIN_PYTHON} ${PROJECT_SOURCE_DIR}/tests/house/quickstart.py)
softgrain_add_house_test(copied_folder quick ${SOFTGRAIN_PYTHON} ${PROJECT_SOURCE_DIR}/tests/house/copied_folder.py
  ${CMAKE_COMMAND} ${PROJECT_SOURCE_DIR} ${CMAKE_BINARY_DIR}/tests/house/copied_folder.run)
softgrain_add_house_test(tolerances quick ${SOFTGRAIN_PYTHON} ${PROJECT_SOURCE_DIR}/tests/house/tolerances.py
  ${CMAKE_COMMAND} ${NUMDIFF} ${CMAKE_BINARY_DIR}/tests/house/tolerances.run)

softgrain_add_house_test(self_contained_headers nightly
  ${SOFTGRAIN_PYTHON} ${PROJECT_SOURCE_DIR}/contrib/checks/self_contained.py --build ${CMAKE_BINARY_DIR})
set_tests_properties(house/self_contained_headers PROPERTIES TIMEOUT 3600) # a compiler run per header

# The commands of every page of the manual, run as a reader would run them.
if(TARGET softgrain_executable)
  function(softgrain_add_manual_test name label)
    softgrain_add_house_test(${name} ${label} ${SOFTGRAIN_PYTHON} ${PROJECT_SOURCE_DIR}/tests/house/manual_commands.py
      --program $<TARGET_FILE:softgrain_executable> --work ${CMAKE_BINARY_DIR}/tests/house/${name}.run ${ARGN})
    set_tests_properties(house/${name} PROPERTIES TIMEOUT 1200)
  endfunction()

  softgrain_add_manual_test(manual_commands_refuses quick)
  file(GLOB pages RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/*.md
    ${PROJECT_SOURCE_DIR}/doc/*.md ${PROJECT_SOURCE_DIR}/doc/results/*.md)
  foreach(page ${pages})
    string(REGEX REPLACE "[/.]" "_" name ${page})
    set(label quick)
    if(page MATCHES "results/")
      set(label nightly)
    endif()
    softgrain_add_manual_test(commands_of_${name} ${label} ${page})
  endforeach()
endif()

find_program(SOFTGRAIN_DOXYGEN doxygen)
if(SOFTGRAIN_DOXYGEN)
  softgrain_add_house_test(reference_manual quick ${SOFTGRAIN_PYTHON}
    ${PROJECT_SOURCE_DIR}/contrib/checks/reference_manual.py --output ${CMAKE_BINARY_DIR}/doc)
endif()
