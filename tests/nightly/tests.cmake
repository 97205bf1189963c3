# SPDX-License-Identifier: LGPL-2.1-or-later
# Longer scenes, compared like the others: ctest -L nightly.
file(GLOB programs CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/nightly/*.cc)
foreach(program ${programs})
  softgrain_add_program_test(nightly ${program})
  get_filename_component(name ${program} NAME_WE)
  set_tests_properties(nightly/${name} PROPERTIES LABELS nightly TIMEOUT 7200)
endforeach()
