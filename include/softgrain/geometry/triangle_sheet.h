// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_triangle_sheet_h
#define softgrain_geometry_triangle_sheet_h

#include <softgrain/geometry/rigid_surface.h>

#include <memory>

namespace softgrain
{
/// A sheet of triangles, closed or open.
class TriangleSheet final : public RigidSurface
{
public:
  /// @param triangles none of which is without an area
  TriangleSheet(TriangulatedSurface triangles, double thickness);
  ~TriangleSheet() override;

  TriangulatedSurface drawn() const override { return sheet; }

protected:
  std::optional<Foot> foot(const dealii::Point<3> &x, double within) const override;

private:
  struct Tree;

  const TriangulatedSurface sheet;
  const std::unique_ptr<const Tree> tree; ///< of the boxes around the triangles
};
} // namespace softgrain

#endif
