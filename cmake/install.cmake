# SPDX-License-Identifier: LGPL-2.1-or-later
include(GNUInstallDirs)
install(TARGETS softgrain LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
if(TARGET softgrain_executable)
  set_target_properties(softgrain_executable PROPERTIES
    INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
  install(TARGETS softgrain_executable RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(DIRECTORY include/softgrain DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY python/ DESTINATION ${CMAKE_INSTALL_DATADIR}/softgrain/python)
install(DIRECTORY parameters DESTINATION ${CMAKE_INSTALL_DATADIR}/softgrain)
