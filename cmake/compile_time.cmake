# SPDX-License-Identifier: LGPL-2.1-or-later
# What keeps a clean build on two cores under five minutes. Parsing deal.II's headers is most of the time a source
# takes, so they are parsed once for everything; debug information and linking are most of the rest.

option(SOFTGRAIN_PRECOMPILE_HEADERS "parse deal.II's headers once for all sources and tests" ON)
option(SOFTGRAIN_FAST_LINKER "link with lld where it is installed" ON)

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  # Without these ccache never finds a source that was compiled with precompiled headers.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE_PROGRAM})
endif()

# deal.II's flags ask for full debug information even in Release: ten megabytes for a source that uses Eigen.
# Function names in a backtrace and in a profile need none of it; sanitizers need lines only.
if(CMAKE_BUILD_TYPE STREQUAL "Release")
  set(SOFTGRAIN_DEBUG_INFORMATION -g0)
elseif(SOFTGRAIN_SANITIZE)
  set(SOFTGRAIN_DEBUG_INFORMATION -g1 -O1)
else()
  # Assertions with inlining: without it (-O0 on Debian) Eigen makes a step tens of times as long.
  set(SOFTGRAIN_DEBUG_INFORMATION -gsplit-dwarf -O1)
endif()

# deal.II names gold; lld needs a third of its time for a test. The last -fuse-ld counts.
set(SOFTGRAIN_LINKER -Wl,--as-needed)
if(SOFTGRAIN_FAST_LINKER)
  find_program(SOFTGRAIN_LLD NAMES ld.lld ld.lld-14)
  if(SOFTGRAIN_LLD MATCHES "/ld\\.lld$")
    list(APPEND SOFTGRAIN_LINKER -fuse-ld=lld)
  endif()
endif()

# One precompiled header for every target with the same flags: CMake's target_precompile_headers alone would parse it,
# and store hundreds of megabytes, once per target.
function(softgrain_add_precompiled_headers)
  if(SOFTGRAIN_PRECOMPILE_HEADERS)
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/precompiled.cc CONTENT "// carries the precompiled header\n")
    add_library(softgrain_precompiled OBJECT ${PROJECT_BINARY_DIR}/precompiled.cc)
    softgrain_setup_target(softgrain_precompiled)
    target_precompile_headers(softgrain_precompiled PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.h)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      target_compile_options(softgrain_options INTERFACE -fpch-preprocess) # for ccache
    endif()
  endif()
endfunction()

function(softgrain_use_precompiled_headers target)
  if(SOFTGRAIN_PRECOMPILE_HEADERS)
    target_precompile_headers(${target} REUSE_FROM softgrain_precompiled)
  endif()
endfunction()
