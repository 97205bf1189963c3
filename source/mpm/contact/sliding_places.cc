// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/sliding_places.h>

namespace softgrain::mpm
{
namespace
{
using Vector = MovedBoundary::Vector;
using Place = MovedBoundary::Place;
} // namespace

std::shared_ptr<const PlaceSlide<2>> slide_of_places(const Body<2> &body,
                                                     const MovedBoundary &own,
                                                     const Vector &direction,
                                                     const Body<2> *partner)
{
  const Place first = own.place(own.facing(direction), true);
  const Vector arm = first.position - own.center;
  const Vector across = Vector({-arm[1], arm[0]}) / arm.norm();
  // The outline crosses the ray at this rate per marker.
  const double rate = across * Vector({-first.normal[1], first.normal[0]}) * first.speed;
  if (!(rate > 0.1 * first.speed))
    return nullptr; // folded: no place of a round body
  const auto whole = [](const Body<2> &one, const Vector &form, Eigen::VectorXd &all)
  {
    const double mass = one.mass.sum();
    for (unsigned int i = 0; i < one.mass.size(); ++i)
      for (unsigned int d = 0; d < 2; ++d)
        all[2 * i + d] += one.mass[i] / mass * form[d];
  };
  auto slide = std::make_shared<PlaceSlide<2>>();
  slide->of_body = Eigen::VectorXd::Zero(body.field.n_dofs());
  for (unsigned int k = 0; k < first.weights.node.size(); ++k)
    for (unsigned int d = 0; d < 2; ++d)
      slide->of_body[2 * first.weights.node[k] + d] -= first.weights.weight[k] * across[d] / rate;
  if (partner != nullptr)
  {
    slide->of_centre = arm.norm() / (direction.norm_square() * rate) * Vector({-direction[1], direction[0]});
    slide->of_partner = Eigen::VectorXd::Zero(partner->field.n_dofs());
    whole(*partner, slide->of_centre, slide->of_partner);
  }
  whole(body, across / rate - slide->of_centre, slide->of_body);
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
  const auto slid = [&](const Eigen::VectorXd &form, const unsigned int b)
  {
    if (form.size() == 0)
      return 0.;
    if (scene.increment != nullptr)
      return form.dot((*scene.increment)[b]);
    const Body<2> &body = scene.bodies[b];
    return body.velocity.size() > 0 ? scene.dt * form.dot(body.velocity) : 0.;
  };
  double way = slid(slide->of_body, row.body);
  if (row.partner != ContactRow<2>::none)
    way += slid(slide->of_partner, row.partner);
  if (scene.cell != nullptr)
    way -= scene.dt * (scene.cell->gradient * row.branch) * slide->of_centre;
  row.gap -= scene.share * row.slope * way;
}
} // namespace softgrain::mpm
