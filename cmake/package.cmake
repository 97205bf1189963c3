# SPDX-License-Identifier: LGPL-2.1-or-later
# `cpack` in the build folder makes a package of Debian:
#   cmake --preset portable && cmake --build --preset portable && (cd build/portable && cpack)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON) # tests need not be built for a package
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME softgrain)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "The softgrain developers <softgrain@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "mechanics of packings of soft particles")
set(CPACK_PACKAGE_DESCRIPTION
  "softgrain computes how packings of soft particles deform, by the material point method or by bonded particles, with contact and friction. It comes with a Python package, headers for constitutive laws of your own, scenes and the manual.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
# Libraries that the program is linked with are found by dpkg-shlibdeps; these it cannot see.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/lib)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libopenblas0-serial, python3-numpy, python3-h5py, python3-matplotlib, python3-vtk9")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg, python3-pandas, python3-xarray, libdeal.ii-dev, cmake, g++")
# A package for this processor alone must not be mistaken for one for all.
if(SOFTGRAIN_NATIVE)
  set(CPACK_DEBIAN_PACKAGE_RELEASE native)
endif()
include(CPack)
