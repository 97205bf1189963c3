# SPDX-License-Identifier: LGPL-2.1-or-later
# What keeps compiling short (doc/results/compile-time.md has the figures). Parsing deal.II's headers is most of
# the time a source takes, so they are parsed once for many; debug information and linking are most of the rest.

option(SOFTGRAIN_PRECOMPILE_HEADERS "parse deal.II's headers once for all sources and tests" ON)
option(SOFTGRAIN_FAST_LINKER "link with lld where it is installed" ON)

# With paths relative to the sources, ccache finds in a copy of this folder what was compiled in another. A build folder that
# is older keeps its absolute ones: with others it would compile everything anew.
if(NOT DEFINED CACHE{CCACHE_PROGRAM})
  set(SOFTGRAIN_RELATIVE_PATHS ON CACHE BOOL "copies of the source folder share what ccache keeps")
endif()
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(SOFTGRAIN_CCACHE_PATHS)
  if(SOFTGRAIN_RELATIVE_PATHS AND CMAKE_BUILD_TYPE STREQUAL "Release") # debug information names the folder
    set(SOFTGRAIN_CCACHE_PATHS CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1)
  endif()
  # Without these ccache never finds a source that was compiled with precompiled headers.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env ${SOFTGRAIN_CCACHE_PATHS}
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

# deal.II names a linker: Debian 12's gold, Debian 13's mold, which no package of deal.II brings. lld needs a third of
# gold's time for a test. The last -fuse-ld counts, so the compiler's own linker is named where there is neither.
set(SOFTGRAIN_LINKER -Wl,--as-needed)
if(SOFTGRAIN_FAST_LINKER)
  find_program(SOFTGRAIN_LLD NAMES ld.lld)
endif()
if(SOFTGRAIN_FAST_LINKER AND SOFTGRAIN_LLD MATCHES "/ld\\.lld$") # an older configuration may remember ld.lld-14
  list(APPEND SOFTGRAIN_LINKER -fuse-ld=lld)
elseif(DEAL_II_LINKER_FLAGS MATCHES "-fuse-ld=([a-z]+)")
  find_program(SOFTGRAIN_NAMED_LINKER NAMES ld.${CMAKE_MATCH_1} ${CMAKE_MATCH_1})
  if(NOT SOFTGRAIN_NAMED_LINKER)
    list(APPEND SOFTGRAIN_LINKER -fuse-ld=bfd)
  endif()
endif()

# Open MPI's own C++ classes, which nobody uses and MPI has dropped, are a second of every source.
set(SOFTGRAIN_COMPILE_DEFINITIONS OMPI_SKIP_MPICXX=1)

# A precompiled header for many targets with the same flags: CMake's target_precompile_headers alone would parse it, and
# store hundreds of megabytes, once per target. There are three, because loading what a source does not need takes time, too.
set(SOFTGRAIN_PRECOMPILED algebra base mesh)

function(softgrain_add_precompiled_headers)
  if(SOFTGRAIN_PRECOMPILE_HEADERS)
    foreach(kind ${SOFTGRAIN_PRECOMPILED})
      file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/precompiled_${kind}.cc CONTENT "// carries the precompiled header\n")
      add_library(softgrain_precompiled_${kind} OBJECT ${PROJECT_BINARY_DIR}/precompiled_${kind}.cc)
      softgrain_setup_target(softgrain_precompiled_${kind})
      target_precompile_headers(softgrain_precompiled_${kind}
        PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled/${kind}.h)
    endforeach()
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      target_compile_options(softgrain_options INTERFACE -fpch-preprocess) # for ccache
    endif()
  endif()
endfunction()

# The one that serves a part, or what uses it.
function(softgrain_use_precompiled_headers target part)
  set(kind base)
  if(part STREQUAL "mpm")
    set(kind mesh)
  elseif(part MATCHES "^(base|contact)$")
    set(kind algebra) # mostly free of deal.II
  endif()
  if(SOFTGRAIN_PRECOMPILE_HEADERS)
    target_precompile_headers(${target} REUSE_FROM softgrain_precompiled_${kind})
  endif()
endfunction()
