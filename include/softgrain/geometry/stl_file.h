// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_stl_file_h
#define softgrain_geometry_stl_file_h

#include <softgrain/geometry/solid.h>

#include <string>

namespace softgrain
{
/// The triangles of an STL file, binary or ASCII, corners at the same place joined; those without an area are
/// left out. @param scale length of its unit [m]. @throw InputError when it is none, or has no triangle
TriangulatedSurface read_stl(const std::string &path, double scale);
} // namespace softgrain

#endif
