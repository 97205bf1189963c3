// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_solid_surface_h
#define softgrain_geometry_solid_surface_h

#include <softgrain/geometry/rest_surface.h>
#include <softgrain/geometry/solid.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace softgrain
{
/// The smooth surface of a shape in space. It has one piece and no edge.
class SolidSurface final : public RestSurface<3>
{
public:
  using Place = SurfacePlace<3>;

  /// @param triangles of the markers of its body, outward: where contact is looked for
  SolidSurface(std::shared_ptr<const Shape<3>> shape, std::vector<std::array<unsigned int, 3>> triangles)
      : triangles(std::move(triangles)), shape(std::move(shape))
  {
  }

  /// The place that lies on the ray from the centre of the shape to @p x, which is not the centre [m].
  Place at(const dealii::Point<3> &x) const { return shape->place(x); }

  /// Goes along the tangent plane and back towards the centre.
  Place move(const Place &place, const dealii::Tensor<1, 2> &way) const override
  {
    return at(place.position + way[0] * place.tangent[0] + way[1] * place.tangent[1]);
  }

  std::vector<std::array<unsigned int, 3>> triangles;

private:
  std::shared_ptr<const Shape<3>> shape;
};
} // namespace softgrain

#endif
