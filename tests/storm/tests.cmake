# SPDX-License-Identifier: LGPL-2.1-or-later
# A storm of random scenes (doc/storm.md): the storm itself in seconds, a small one beside the quick suite
# (ctest -L storm), a long one every night.
if(TARGET softgrain_executable AND EXISTS ${PROJECT_SOURCE_DIR}/source/mpm)
  set(storm ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 ${SOFTGRAIN_PYTHON})
  foreach(name scenes faults)
    add_test(NAME storm/${name}
      COMMAND ${storm} ${CMAKE_CURRENT_SOURCE_DIR}/storm/test_${name}.py $<TARGET_FILE:softgrain_executable>
        ${CMAKE_BINARY_DIR}/tests/storm/${name}.run)
    set_tests_properties(storm/${name} PROPERTIES LABELS "quick;storm" TIMEOUT ${SOFTGRAIN_TEST_TIMEOUT})
  endforeach()

  # A new folder every time: results of an earlier program would be taken for those of this one.
  function(softgrain_add_storm name label)
    add_test(NAME ${name}
      COMMAND ${storm} ${CMAKE_CURRENT_SOURCE_DIR}/storm/storm.py --program $<TARGET_FILE:softgrain_executable>
        --owed ${CMAKE_CURRENT_SOURCE_DIR}/storm/owed.txt --output ${CMAKE_BINARY_DIR}/tests/${name}.run --anew ${ARGN})
    set_tests_properties(${name} PROPERTIES LABELS "${label}" TIMEOUT 7200)
  endfunction()
  softgrain_add_storm(storm/small storm --seeds 1-20 --jobs 2 --shrink 60)
  softgrain_add_storm(nightly/storm nightly --seeds 1-1000 --jobs 2 --seconds 2700 --shrink 600)
endif()
