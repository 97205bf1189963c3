# SPDX-License-Identifier: LGPL-2.1-or-later
# One object library per part, all of them in one shared library, and a thin executable.

add_library(softgrain_options INTERFACE)
target_include_directories(softgrain_options INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/bpm/include>
  $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>)
target_compile_options(softgrain_options INTERFACE -Wall -Wextra -Wpedantic -Wno-missing-braces
  $<$<CONFIG:Release>:-O3>)
# GCC 12 takes the AVX-512 intrinsics of its own headers for uninitialised: megabytes of warnings that are not ours.
target_compile_options(softgrain_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
target_compile_options(softgrain_options INTERFACE ${SOFTGRAIN_DEBUG_INFORMATION})
target_compile_definitions(softgrain_options INTERFACE ${SOFTGRAIN_COMPILE_DEFINITIONS})
target_link_options(softgrain_options INTERFACE ${SOFTGRAIN_LINKER})
if(SOFTGRAIN_NATIVE)
  target_compile_options(softgrain_options INTERFACE -march=native)
endif()
if(SOFTGRAIN_WARNINGS_AS_ERRORS)
  target_compile_options(softgrain_options INTERFACE -Werror)
endif()
if(SOFTGRAIN_SANITIZE)
  target_compile_options(softgrain_options INTERFACE
    -fsanitize=address,undefined -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  target_link_options(softgrain_options INTERFACE -fsanitize=address,undefined)
endif()
target_link_libraries(softgrain_options INTERFACE
  Eigen3::Eigen CLI11::CLI11 nlohmann_json::nlohmann_json ${HDF5_C_LIBRARIES} muparser ${CMAKE_DL_LIBS})
# Headers of packages are not ours to mend: their warnings stay quiet.
target_include_directories(softgrain_options SYSTEM INTERFACE
  ${HDF5_C_INCLUDE_DIRS} ${DEAL_II_INCLUDE_DIRS})

include(GNUInstallDirs)
configure_file(${PROJECT_SOURCE_DIR}/cmake/config.h.in
  ${PROJECT_BINARY_DIR}/include/softgrain/base/config.h @ONLY)

function(softgrain_setup_target target)
  deal_ii_setup_target(${target})
  target_link_libraries(${target} softgrain_options)
  # Programs are compiled as the precompiled headers are, or GCC does not take these. deal.II 9.4 sees to that itself.
  get_target_property(type ${target} TYPE)
  if(type STREQUAL "EXECUTABLE")
    if(NOT DEAL_II_CXX_FLAGS MATCHES "-fPIC")
      target_compile_options(${target} PRIVATE -fPIC)
    endif()
    softgrain_use_stand_ins(${target})
  endif()
endfunction()

softgrain_add_precompiled_headers()

set(SOFTGRAIN_PARTS base parameters linear contact constitutive geometry analysis packing scene model output driving mpm bpm
  app)
add_library(softgrain SHARED)
foreach(part ${SOFTGRAIN_PARTS})
  if(part STREQUAL "bpm")
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bpm/source/*.cc)
  else()
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/source/${part}/*.cc)
    list(FILTER sources EXCLUDE REGEX "/main\\.cc$")
    if(SOFTGRAIN_HAS_TRILINOS)
      list(FILTER sources EXCLUDE REGEX "/trilinos_missing\\.cc$")
    else()
      list(FILTER sources EXCLUDE REGEX "/trilinos_solver\\.cc$")
    endif()
  endif()
  if(sources)
    add_library(softgrain_${part} OBJECT ${sources})
    softgrain_setup_target(softgrain_${part})
    softgrain_use_precompiled_headers(softgrain_${part} ${part})
    target_sources(softgrain PRIVATE $<TARGET_OBJECTS:softgrain_${part}>)
  endif()
endforeach()
softgrain_setup_target(softgrain)
set_target_properties(softgrain PROPERTIES LINKER_LANGUAGE CXX)

if(EXISTS ${PROJECT_SOURCE_DIR}/source/app/main.cc)
  add_executable(softgrain_executable source/app/main.cc)
  set_target_properties(softgrain_executable PROPERTIES OUTPUT_NAME softgrain)
  softgrain_setup_target(softgrain_executable)
  softgrain_use_precompiled_headers(softgrain_executable app)
  target_link_libraries(softgrain_executable softgrain)
endif()

# Checks the laws of a library, installed for those who write one.
add_executable(softgrain_law_tester ${PROJECT_SOURCE_DIR}/tests/constitutive/tester/law_tester.cc)
set_target_properties(softgrain_law_tester PROPERTIES OUTPUT_NAME softgrain-law-tester)
target_include_directories(softgrain_law_tester PRIVATE ${PROJECT_SOURCE_DIR}/tests)
softgrain_setup_target(softgrain_law_tester)
softgrain_use_precompiled_headers(softgrain_law_tester constitutive)
target_link_libraries(softgrain_law_tester softgrain)
