# SPDX-License-Identifier: LGPL-2.1-or-later
include(GNUInstallDirs)
install(TARGETS softgrain LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
set(softgrain_search_path "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
if(SOFTGRAIN_STAND_INS_DIR)
  install(DIRECTORY ${SOFTGRAIN_STAND_INS_DIR} DESTINATION ${CMAKE_INSTALL_LIBDIR} FILE_PERMISSIONS OWNER_READ OWNER_WRITE
    GROUP_READ WORLD_READ)
  list(PREPEND softgrain_search_path "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}/softgrain-stand-ins") # below /usr the real ones are beside
endif()
if(TARGET softgrain_executable)
  set_target_properties(softgrain_executable PROPERTIES
    INSTALL_RPATH "${softgrain_search_path}")
  install(TARGETS softgrain_executable RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
if(TARGET softgrain_law_tester)
  set_target_properties(softgrain_law_tester PROPERTIES
    INSTALL_RPATH "${softgrain_search_path}")
  install(TARGETS softgrain_law_tester RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(DIRECTORY include/softgrain bpm/include/softgrain ${PROJECT_BINARY_DIR}/include/softgrain
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DATADIR}/softgrain)
install(DIRECTORY python/ DESTINATION ${CMAKE_INSTALL_DATADIR}/softgrain/python
  FILES_MATCHING PATTERN "*.py" PATTERN "page.*" PATTERN "__pycache__" EXCLUDE PATTERN "build" EXCLUDE PATTERN "*.egg-info" EXCLUDE)
install(DIRECTORY contrib/third-party DESTINATION ${CMAKE_INSTALL_DATADIR}/softgrain)
# The package once more where Python looks for it: Debian has one folder for its own packages and one per version for
# /usr/local. The prefix is known only when something is installed.
if(SOFTGRAIN_PYTHON)
  execute_process(COMMAND ${SOFTGRAIN_PYTHON} -c "import sys; print('python%d.%d' % sys.version_info[:2], end='')"
    OUTPUT_VARIABLE softgrain_python_version)
  install(CODE "
    set(folder lib/${softgrain_python_version}/dist-packages)
    if(\"\${CMAKE_INSTALL_PREFIX}\" STREQUAL /usr)
      set(folder lib/python3/dist-packages)
    endif()
    file(INSTALL DESTINATION \"\${CMAKE_INSTALL_PREFIX}/\${folder}\" TYPE DIRECTORY
      FILES \"${PROJECT_SOURCE_DIR}/python/softgrain\" PATTERN __pycache__ EXCLUDE)")
endif()
install(DIRECTORY parameters DESTINATION ${CMAKE_INSTALL_DATADIR}/softgrain)
install(DIRECTORY doc/ DESTINATION ${CMAKE_INSTALL_DOCDIR}
  PATTERN softgrain.1 EXCLUDE PATTERN Doxyfile EXCLUDE PATTERN style.css EXCLUDE)
install(FILES README.md LICENSE CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES doc/softgrain.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES contrib/softgrain.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  RENAME softgrain)
