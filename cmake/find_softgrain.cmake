# SPDX-License-Identifier: LGPL-2.1-or-later
# What find_package(softgrain) reads: one file in the build folder, one for an installation.
include(CMakePackageConfigHelpers)
set(softgrain_config_folder ${CMAKE_INSTALL_DATADIR}/cmake/softgrain) # found before project(), too
write_basic_package_version_file(${PROJECT_BINARY_DIR}/softgrainConfigVersion.cmake COMPATIBILITY SameMinorVersion)

set(SOFTGRAIN_CONFIG_TO_PREFIX .)
set(SOFTGRAIN_CONFIG_LIBDIR lib)
set(SOFTGRAIN_CONFIG_BINDIR bin)
set(SOFTGRAIN_CONFIG_INCLUDE_DIRS
  "\"${PROJECT_SOURCE_DIR}/include\" \"${PROJECT_SOURCE_DIR}/bpm/include\" \"${PROJECT_BINARY_DIR}/include\"")
configure_file(${PROJECT_SOURCE_DIR}/cmake/softgrainConfig.cmake.in ${PROJECT_BINARY_DIR}/softgrainConfig.cmake @ONLY)

file(RELATIVE_PATH SOFTGRAIN_CONFIG_TO_PREFIX /prefix/${softgrain_config_folder} /prefix)
set(SOFTGRAIN_CONFIG_LIBDIR ${CMAKE_INSTALL_LIBDIR})
set(SOFTGRAIN_CONFIG_BINDIR ${CMAKE_INSTALL_BINDIR})
set(SOFTGRAIN_CONFIG_INCLUDE_DIRS ${CMAKE_INSTALL_INCLUDEDIR})
configure_file(${PROJECT_SOURCE_DIR}/cmake/softgrainConfig.cmake.in
  ${PROJECT_BINARY_DIR}/installed/softgrainConfig.cmake @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/installed/softgrainConfig.cmake ${PROJECT_BINARY_DIR}/softgrainConfigVersion.cmake
  DESTINATION ${softgrain_config_folder})
