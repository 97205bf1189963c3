// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/sliding_places.h>

namespace softgrain::mpm
{
namespace
{
using Vector = MovedBoundary::Vector;
using Place = MovedBoundary::Place;
} // namespace

std::shared_ptr<const PlaceSlide<2>>
slide_of_places(const MovedBoundary &own, const Vector &direction, const MovedBoundary *partner)
{
  const double parameter = own.facing(direction);
  const Place first = own.place(parameter);
  const Vector arm = first.position - own.center;
  const Vector across = Vector({-arm[1], arm[0]}) / arm.norm();
  // The outline crosses the ray at this rate per marker.
  const double rate = across * Vector({-first.normal[1], first.normal[0]}) * first.speed;
  if (!(rate > 0.1 * first.speed))
    return nullptr; // folded: no place of a round body
  auto slide = std::make_shared<PlaceSlide<2>>();
  slide->across = across / rate;
  if (partner != nullptr)
    slide->of_centre = arm.norm() / (direction.norm_square() * rate) * Vector({-direction[1], direction[0]});
  slide->of_body_centre = slide->across - slide->of_centre;
  // What a cell that repeats does to the body it does to its outline, too.
  slide->way = -(slide->across * (first.displacement - own.travel)) - slide->of_centre * own.nodal_travel;
  if (partner != nullptr)
    slide->way += slide->of_centre * partner->nodal_travel;
  slide->place = own.weights(parameter);
  return slide;
}

void add_slope(const ContactScene<2> &scene,
               const Place &at,
               const std::shared_ptr<const PlaceSlide<2>> &slide,
               ContactRow<2> &row)
{
  if (slide == nullptr || row.friction > 0.)
    return;
  row.slide = slide;
  row.slope = Vector({-at.normal[1], at.normal[0]}) * row.normal * at.speed;
  if (scene.share == 0.)
    return;
  double way = slide->way;
  if (scene.cell != nullptr)
    way -= scene.dt * (scene.cell->gradient * row.branch) * slide->of_centre;
  row.gap -= scene.share * row.slope * way;
}
} // namespace softgrain::mpm
