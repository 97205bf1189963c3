# SPDX-License-Identifier: LGPL-2.1-or-later
# A start takes less than half the time where programs leave out Gmsh and OpenCASCADE, which deal.II brings and softgrain never
# calls (doc/platforms.md has the figures). Programs look for libraries in the folder of their stand-ins first.

option(SOFTGRAIN_STAND_INS "start without Gmsh and OpenCASCADE, which deal.II brings and softgrain never calls" ON)
set(SOFTGRAIN_STAND_INS_DIR)

# Path of deal.II's library for this type of build.
function(softgrain_find_deal_ii_library result)
  set(${result} "" PARENT_SCOPE)
  set(target ${DEAL_II_TARGET_RELEASE})
  if(CMAKE_BUILD_TYPE STREQUAL "Debug")
    set(target ${DEAL_II_TARGET_DEBUG})
  endif()
  if(NOT TARGET "${target}")
    include(${DEAL_II_TARGET_CONFIG}) # deal.II 9.4 does so for the first program only
  endif()
  get_target_property(configurations ${target} IMPORTED_CONFIGURATIONS)
  foreach(property IMPORTED_LOCATION ${configurations})
    if(NOT property STREQUAL "IMPORTED_LOCATION")
      set(property IMPORTED_LOCATION_${property})
    endif()
    get_target_property(location ${target} ${property})
    if(location MATCHES "\\.so[.0-9]*$" AND EXISTS "${location}")
      set(${result} ${location} PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

# The folder is part of the programs, and the check of the stand-ins takes a loader of this machine.
if(SOFTGRAIN_STAND_INS AND CMAKE_SYSTEM_NAME STREQUAL "Linux" AND NOT CMAKE_CROSSCOMPILING AND SOFTGRAIN_PYTHON)
  softgrain_find_deal_ii_library(library)
  if(library)
    set(folder ${PROJECT_BINARY_DIR}/lib/softgrain-stand-ins)
    set(script ${PROJECT_SOURCE_DIR}/cmake/stand_ins.py)
    file(TIMESTAMP "${library}" changed)
    file(SHA256 ${script} made_by)
    set(wanted "${library} ${changed} ${made_by} ${folder}")
    if(NOT wanted STREQUAL "$CACHE{SOFTGRAIN_STAND_INS_MADE}") # they take seconds
      execute_process(COMMAND ${SOFTGRAIN_PYTHON} -B ${script} ${library} ${folder} --compiler ${CMAKE_C_COMPILER}
        RESULT_VARIABLE failed ERROR_VARIABLE reason)
      if(failed)
        file(REMOVE_RECURSE ${folder})
        message(STATUS "programs start slower: ${reason}")
      endif()
      set(SOFTGRAIN_STAND_INS_MADE ${wanted} CACHE INTERNAL "what the stand-ins were made for")
    endif()
    file(GLOB made ${folder}/*)
    if(made)
      set(SOFTGRAIN_STAND_INS_DIR ${folder})
    endif()
  endif()
endif()

# Lets a program find the stand-ins, where they are built and where they are installed. Only the older of the two kinds of
# search path, DT_RPATH, counts for libraries of libraries, too.
function(softgrain_use_stand_ins target)
  if(SOFTGRAIN_STAND_INS_DIR)
    target_link_options(${target} PRIVATE -Wl,--disable-new-dtags)
    set_property(TARGET ${target} APPEND PROPERTY BUILD_RPATH ${SOFTGRAIN_STAND_INS_DIR})
  endif()
endfunction()
