# SPDX-License-Identifier: LGPL-2.1-or-later
# Runs PROGRAM in its own folder, keeps what it prints in `output`, and compares it with EXPECTED by numdiff.
# A number is right when its error is within the absolute OR the relative tolerance, so the absolute one must be far
# below every number that means something. Lines at the head of EXPECTED set them (default 1e-9 1e-7), those of a
# column (the Nth word of a line) for it alone:
# # tolerance: ABSOLUTE RELATIVE
# # tolerance of column N: ABSOLUTE RELATIVE
# With RANKS it runs on so many, whatever the cores: MPIRUN starts them.
set(launcher "")
if(RANKS)
  set(launcher OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 ${MPIRUN} --oversubscribe -n ${RANKS})
endif()
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
execute_process(COMMAND ${CMAKE_COMMAND} -E env DEAL_II_NUM_THREADS=${THREADS} OMP_NUM_THREADS=1 ${launcher}
    ${PROGRAM} ${ARGUMENTS}
  WORKING_DIRECTORY ${WORK} OUTPUT_FILE ${WORK}/output ERROR_FILE ${WORK}/errors RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  file(READ ${WORK}/output printed)
  file(READ ${WORK}/errors errors)
  message(FATAL_ERROR "the program ended with ${status}\n${printed}\n${errors}")
endif()
set(absolute 1e-9)
set(relative 1e-7)
set(columns "")
file(STRINGS ${EXPECTED} heads REGEX "^# tolerance")
foreach(head ${heads})
  if(head MATCHES "^# tolerance: ([^ ]+) ([^ ]+)$")
    set(absolute ${CMAKE_MATCH_1})
    set(relative ${CMAKE_MATCH_2})
  elseif(head MATCHES "^# tolerance of column ([0-9]+): ([^ ]+) ([^ ]+)$")
    list(APPEND columns -a ${CMAKE_MATCH_2}:${CMAKE_MATCH_1} -r ${CMAKE_MATCH_3}:${CMAKE_MATCH_1})
  else()
    message(FATAL_ERROR "${EXPECTED}: '${head}' is not understood")
  endif()
endforeach()
# As one text, not as a list of lines: CMake's lists trip over brackets and semicolons.
file(READ ${EXPECTED} expected)
string(REGEX REPLACE "# tolerance[^\n]*\n" "" expected "${expected}")
file(WRITE ${WORK}/expected "${expected}")
execute_process(COMMAND ${NUMDIFF} -a ${absolute} -r ${relative} ${columns} -s "' \\t\\n=,:;<>[](){}^'" ${WORK}/expected ${WORK}/output
  RESULT_VARIABLE differs OUTPUT_VARIABLE report ERROR_VARIABLE report_errors)
if(NOT differs EQUAL 0)
  message(FATAL_ERROR "differs from ${EXPECTED}:\n${report}${report_errors}")
endif()
