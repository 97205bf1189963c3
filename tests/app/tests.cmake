# SPDX-License-Identifier: LGPL-2.1-or-later
# Files with one fault each must end `softgrain check` with exit code 2 and one clear line; every file that is
# shipped must pass it. Both need a program with its models.

if(EXISTS ${PROJECT_SOURCE_DIR}/source/mpm)
  function(softgrain_add_check_test name script)
    add_test(NAME ${name}
      COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:softgrain_executable> ${ARGN}
        -P ${CMAKE_CURRENT_SOURCE_DIR}/app/${script})
    set_tests_properties(${name} PROPERTIES LABELS "quick;app" TIMEOUT ${SOFTGRAIN_TEST_TIMEOUT})
  endfunction()

  file(GLOB broken CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/app/broken/*.prm
    ${CMAKE_CURRENT_SOURCE_DIR}/app/broken/*.json)
  foreach(file ${broken})
    get_filename_component(name ${file} NAME)
    softgrain_add_check_test(app/broken/${name} check_broken.cmake -DFILE=${file}
      -DWORK=${CMAKE_BINARY_DIR}/tests/app/broken/${name}.run)
  endforeach()
  softgrain_add_check_test(app/broken/missing_file check_broken.cmake
    -DFILE=${CMAKE_CURRENT_SOURCE_DIR}/app/broken/nothing.prm "-DEXPECTED=nothing.prm: there is no such file"
    -DWORK=${CMAKE_BINARY_DIR}/tests/app/broken/missing_file.run)
  softgrain_add_check_test(app/broken/folder check_broken.cmake
    -DFILE=${CMAKE_CURRENT_SOURCE_DIR}/app/broken "-DEXPECTED=is a folder, not a parameter file"
    -DWORK=${CMAKE_BINARY_DIR}/tests/app/broken/folder.run)

  file(GLOB_RECURSE shipped CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/parameters/*.prm)
  foreach(file ${shipped})
    if(file MATCHES "/parameters/studies/") # no scenes; the test python/study reads them
      continue()
    endif()
    file(RELATIVE_PATH name ${PROJECT_SOURCE_DIR} ${file})
    # The preparation of hundreds of aggregates is what takes time; a handful has the same parameters.
    set(changes "")
    if(name MATCHES "uniaxial_compaction_bpm")
      set(changes "-DCHANGES=Packing/Number=5")
    endif()
    softgrain_add_check_test(app/${name} check_shipped.cmake -DFILE=${file} ${changes}
      -DWORK=${CMAKE_BINARY_DIR}/tests/app/${name}.run)
  endforeach()

  add_test(NAME app/command_line
    COMMAND ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/app/command_line.py $<TARGET_FILE:softgrain_executable>
      ${PROJECT_SOURCE_DIR} ${CMAKE_BINARY_DIR}/tests/app/command_line.run)
  set_tests_properties(app/command_line PROPERTIES LABELS "quick;app" TIMEOUT ${SOFTGRAIN_TEST_TIMEOUT})
  add_test(NAME app/trial
    COMMAND ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/app/trial.py $<TARGET_FILE:softgrain_executable>
      ${PROJECT_SOURCE_DIR} ${CMAKE_BINARY_DIR}/tests/app/trial.run)
  # It compares processor times, which a test beside it makes longer, both alike.
  set_tests_properties(app/trial PROPERTIES LABELS "quick;app" TIMEOUT ${SOFTGRAIN_TEST_TIMEOUT})
  # The program, linked with its libraries once for many calls.
  add_executable(test_app_many_starts ${CMAKE_CURRENT_SOURCE_DIR}/app/starts/many_starts.cc
    ${PROJECT_SOURCE_DIR}/source/app/main.cc)
  set_source_files_properties(${PROJECT_SOURCE_DIR}/source/app/main.cc PROPERTIES COMPILE_DEFINITIONS main=softgrain_main)
  set_target_properties(test_app_many_starts PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests/app)
  softgrain_setup_target(test_app_many_starts)
  target_link_libraries(test_app_many_starts softgrain)
  add_test(NAME app/careful_inputs
    COMMAND ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/app/careful_inputs.py $<TARGET_FILE:test_app_many_starts>
      ${PROJECT_SOURCE_DIR} ${CMAKE_BINARY_DIR}/tests/app/careful_inputs.run)
  set_tests_properties(app/careful_inputs PROPERTIES LABELS "quick;app" TIMEOUT ${SOFTGRAIN_TEST_TIMEOUT})
endif()

if(SOFTGRAIN_STAND_INS_DIR)
  add_test(NAME app/stand_ins
    COMMAND ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/app/stand_ins.py $<TARGET_FILE:softgrain_executable>
      ${SOFTGRAIN_STAND_INS_DIR})
  set_tests_properties(app/stand_ins PROPERTIES LABELS "quick;app" TIMEOUT ${SOFTGRAIN_TEST_TIMEOUT})
endif()

# Kills and refused writes at every call need a library that is loaded before the C library.
add_library(test_app_stop_at_call MODULE ${CMAKE_CURRENT_SOURCE_DIR}/app/preload/stop_at_call.c)
set_target_properties(test_app_stop_at_call PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests/app)
target_link_libraries(test_app_stop_at_call dl)

# Whole runs of the program: what comes in their way, and what both models share.
if(EXISTS ${PROJECT_SOURCE_DIR}/source/mpm)
  foreach(name writes.Writes.test_mpm writes.Writes.test_bpm writes.Writes.test_space damaged_states.DamagedStates.test_mpm
      damaged_states.DamagedStates.test_mpm_cell damaged_states.DamagedStates.test_mpm_static
      damaged_states.DamagedStates.test_bpm limits.Limits
      runs.FullDisk runs.OldResults runs.OneFolder runs.Signals runs.RunLog
      models.OtherSettings models.BothModels models.PackingOfMaterials models.LinearSolvers models.DissipativeLaw
      ranks.Restarts ranks.Ends ranks.Moves ranks.SameBits.test_two_disks ranks.SameBits.test_thirty ranks.SameBits.test_friction
      ranks.SameBits.test_plastic ranks.SameBits.test_pushed ranks.SameBits.test_explicit ranks.SameBits.test_quasi_static
      ranks.SameBits.test_biaxial ranks.SameBits.test_periodic ranks.SameBits.test_thesis_method ranks.SameBits.test_rays
      ranks.SameBits.test_bonded ranks.SameBits.test_bonded_friction ranks.SameBits.test_bonded_pressed
      ranks.SameBits.test_bonded_grain ranks.SameBits.test_bonded_cell
      ranks.SameBits.test_adhesion ranks.SameBits.test_bonded_adhesion ranks.SameBits.test_cell_of_balls
      ranks.SameBits.test_moving_balls ranks.SameBits.test_explicit_balls ranks.SameBits.test_plastic_balls)
    string(REGEX MATCH "^[a-z_]+" script ${name})
    string(REGEX REPLACE "^[a-z_]+\\." "" class ${name})
    add_test(NAME app/${name}
      COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1
        SOFTGRAIN_TEST_LAW=${CMAKE_BINARY_DIR}/tests/constitutive/libtest_constitutive_module_dissipative.so
        SOFTGRAIN_TEST_TRILINOS=${SOFTGRAIN_HAS_TRILINOS}
        SOFTGRAIN_TEST_PRELOAD=$<TARGET_FILE:test_app_stop_at_call>
        ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/app/${script}.py $<TARGET_FILE:softgrain_executable>
        ${PROJECT_SOURCE_DIR}/parameters ${CMAKE_BINARY_DIR}/tests/app/whole_runs ${class})
    set_tests_properties(app/${name} PROPERTIES LABELS "quick;app" TIMEOUT ${SOFTGRAIN_TEST_TIMEOUT})
  endforeach()
endif()
