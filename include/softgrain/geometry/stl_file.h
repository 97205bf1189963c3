// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_stl_file_h
#define softgrain_geometry_stl_file_h

#include <softgrain/geometry/solid.h>

#include <string>

namespace softgrain
{
/// The triangles of an STL file, binary or ASCII. Corners are joined that are at the same place, to a
/// millionth of the extent; triangles without an area are left out. @param scale length of its unit [m]
/// @throw InputError when it is none, or has no triangle
TriangulatedSurface read_stl(const std::string &path, double scale);
} // namespace softgrain

#endif
