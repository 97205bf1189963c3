# SPDX-License-Identifier: LGPL-2.1-or-later
# Longer scenes, compared like the others: ctest -L nightly.
file(GLOB programs CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/nightly/*.cc)
foreach(program ${programs})
  softgrain_add_program_test(nightly ${program})
  get_filename_component(name ${program} NAME_WE)
  set_tests_properties(nightly/${name} PROPERTIES LABELS nightly TIMEOUT 7200)
endforeach()

# Damaged files of every kind, as many as count as proof, with everything that reads them under the sanitizers: what
# stands in the program counts before what the library has. It takes minutes to compile, which only this test does.
if(EXISTS ${PROJECT_SOURCE_DIR}/source/mpm)
  # Sources that register members would do so twice.
  set(readers bpm/source/aggregate_library source/app/input source/base/expression source/base/hdf5_disk_file
    source/base/nearest_name source/contact/problem_io source/contact/siconos_problem source/packing/packing
    source/packing/packing_file source/scene/contact_pairs source/scene/pair_table)
  list(TRANSFORM readers REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/\\1.cc")
  file(GLOB parts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/source/parameters/*.cc
    ${PROJECT_SOURCE_DIR}/source/scene/*_parameters.cc ${PROJECT_SOURCE_DIR}/source/output/checkpoint.cc
    ${PROJECT_SOURCE_DIR}/source/output/hdf5_*.cc ${PROJECT_SOURCE_DIR}/source/output/se*.cc
    ${PROJECT_SOURCE_DIR}/source/output/field_writer.cc ${PROJECT_SOURCE_DIR}/source/output/history.cc)
  add_executable(test_nightly_mutations EXCLUDE_FROM_ALL ${CMAKE_CURRENT_SOURCE_DIR}/app/mutations.cc ${readers}
    ${parts})
  set_target_properties(test_nightly_mutations PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests/nightly)
  softgrain_setup_target(test_nightly_mutations)
  target_compile_definitions(test_nightly_mutations PRIVATE SOFTGRAIN_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_compile_options(test_nightly_mutations PRIVATE -g1 -O1 -fsanitize=address,undefined
    -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  target_link_options(test_nightly_mutations PRIVATE -fsanitize=address,undefined)
  target_link_libraries(test_nightly_mutations softgrain)
  if(SOFTGRAIN_PRECOMPILE_HEADERS)
    # One of its own: the others are made without the sanitizers.
    target_precompile_headers(test_nightly_mutations PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled/mesh.h)
  endif()
  add_test(NAME nightly/mutations_compiled
    COMMAND ${CMAKE_COMMAND} --build ${CMAKE_BINARY_DIR} --target test_nightly_mutations)
  set_tests_properties(nightly/mutations_compiled PROPERTIES LABELS nightly TIMEOUT 3600 FIXTURES_SETUP mutations)
  add_test(NAME nightly/mutations
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:test_nightly_mutations> -DARGUMENTS=100000
      -DEXPECTED=${CMAKE_CURRENT_SOURCE_DIR}/app/mutations.output -DTHREADS=1 -DNUMDIFF=${NUMDIFF}
      -DWORK=${CMAKE_BINARY_DIR}/tests/nightly/mutations.run -P ${SOFTGRAIN_TEST_DRIVER})
  set_tests_properties(nightly/mutations PROPERTIES LABELS nightly TIMEOUT 7200 FIXTURES_REQUIRED mutations)
endif()

# Kills and refusals at every call that touches a file; every list of checkpoints damaged in every way.
if(EXISTS ${PROJECT_SOURCE_DIR}/source/mpm)
  foreach(script writes damaged_states)
    add_test(NAME nightly/${script}
      COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 SOFTGRAIN_ALL_WRITES=1 SOFTGRAIN_ALL_DAMAGES=1
        SOFTGRAIN_TEST_PRELOAD=$<TARGET_FILE:test_app_stop_at_call>
        ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/app/${script}.py $<TARGET_FILE:softgrain_executable>
        ${PROJECT_SOURCE_DIR}/parameters ${CMAKE_BINARY_DIR}/tests/nightly/${script})
    set_tests_properties(nightly/${script} PROPERTIES LABELS nightly TIMEOUT 7200)
  endforeach()
endif()

# Kills at random moments, damaged checkpoints.
if(EXISTS ${PROJECT_SOURCE_DIR}/source/mpm)
  add_test(NAME nightly/faults
    COMMAND ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/nightly/faults.py $<TARGET_FILE:softgrain_executable>
      ${PROJECT_SOURCE_DIR}/parameters ${CMAKE_BINARY_DIR}/tests/nightly/faults)
  set_tests_properties(nightly/faults PROPERTIES LABELS nightly TIMEOUT 7200)
endif()

# What check foretells; parameters at their limits; what presets are worth.
if(EXISTS ${PROJECT_SOURCE_DIR}/source/mpm)
  foreach(name forecasts fidelity)
    add_test(NAME nightly/${name}
      COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=${PROJECT_SOURCE_DIR}/python
        ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/nightly/${name}.py $<TARGET_FILE:softgrain_executable>
        ${PROJECT_SOURCE_DIR}/parameters ${CMAKE_BINARY_DIR}/tests/nightly/${name})
    set_tests_properties(nightly/${name} PROPERTIES LABELS nightly TIMEOUT 7200)
  endforeach()
  add_test(NAME nightly/extremes
    COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1
      ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/nightly/extremes.py $<TARGET_FILE:softgrain_executable>
      ${CMAKE_BINARY_DIR}/tests/nightly/extremes)
  set_tests_properties(nightly/extremes PROPERTIES LABELS nightly TIMEOUT 7200)
  add_test(NAME app/extremes
    COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1
      ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/nightly/extremes.py $<TARGET_FILE:softgrain_executable>
      ${CMAKE_BINARY_DIR}/tests/app/extremes --quick)
  set_tests_properties(app/extremes PROPERTIES LABELS "quick;app" TIMEOUT ${SOFTGRAIN_TEST_TIMEOUT})
endif()

# Yield, indentation and creep of line contacts, beside closed forms.
if(EXISTS ${PROJECT_SOURCE_DIR}/source/mpm)
  add_test(NAME nightly/known_answers
    COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1
      ${SOFTGRAIN_PYTHON} ${PROJECT_SOURCE_DIR}/contrib/results/known_answers.py $<TARGET_FILE:softgrain_executable>
      ${CMAKE_BINARY_DIR}/tests/nightly/known_answers)
  set_tests_properties(nightly/known_answers PROPERTIES LABELS nightly TIMEOUT 7200)
endif()

# ParaView opens what a run writes.
set(SOFTGRAIN_PARAVIEW "" CACHE PATH "folder into which contrib/paraview_beside.sh unpacked ParaView")
if(EXISTS ${PROJECT_SOURCE_DIR}/source/mpm)
  add_test(NAME nightly/paraview
    COMMAND ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/nightly/paraview.py $<TARGET_FILE:softgrain_executable>
      ${CMAKE_CURRENT_SOURCE_DIR}/python/example.prm ${CMAKE_BINARY_DIR}/tests/nightly/paraview ${SOFTGRAIN_PARAVIEW})
  set_tests_properties(nightly/paraview PROPERTIES LABELS nightly TIMEOUT 600 SKIP_RETURN_CODE 77)
endif()

# Installation and package, with a law built against each.
if(TARGET softgrain_law_tester)
  foreach(kind prefix package)
    add_test(NAME nightly/installed_${kind}
      COMMAND ${SOFTGRAIN_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/nightly/installed.py ${CMAKE_BINARY_DIR}
        ${CMAKE_BINARY_DIR}/tests/nightly/installed_${kind} ${kind})
    set_tests_properties(nightly/installed_${kind} PROPERTIES LABELS nightly TIMEOUT 1200 SKIP_RETURN_CODE 77)
  endforeach()
endif()
