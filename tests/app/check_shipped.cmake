# SPDX-License-Identifier: LGPL-2.1-or-later
# `PROGRAM check FILE` (with CHANGES set, if any) must pass in an empty folder, say nothing on stderr and write
# nothing. What a file sets has an effect.
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
set(assignment "")
if(CHANGES)
  set(assignment --set ${CHANGES})
endif()
execute_process(COMMAND ${PROGRAM} check ${FILE} ${assignment}
  WORKING_DIRECTORY ${WORK} OUTPUT_VARIABLE printed ERROR_VARIABLE errors RESULT_VARIABLE status)
if(NOT status EQUAL 0 OR NOT errors STREQUAL "")
  message(FATAL_ERROR "exit code ${status}\n${printed}\n${errors}")
endif()
if(printed MATCHES "has no effect")
  message(FATAL_ERROR "${printed}")
endif()
file(GLOB written ${WORK}/*)
if(written)
  message(FATAL_ERROR "check has written ${written}")
endif()
