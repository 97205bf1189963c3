// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/measure.h>
#include <softgrain/analysis/partner_numbers.h>
#include <softgrain/base/exceptions.h>

#include <algorithm>
#include <cmath>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::MeasureIn<2>)
SOFTGRAIN_DEFINE_REGISTRY(softgrain::MeasureIn<3>)

namespace softgrain
{
namespace
{
/// Measures divide by areas and look up bodies, so both are verified once for all of them.
template <int dim>
void check(const Snapshot<dim> &snapshot)
{
  for (const BodyState<dim> &body : snapshot.bodies)
    if (!(body.area > 0.) || !(body.reference_area > 0.) || body.outline.empty())
      throw ComputationError("body '" + body.name + "' has no outline or no area at t = " +
                             std::to_string(snapshot.time) + " s: nothing can be measured");
  constexpr unsigned int none = ContactState<dim>::not_a_body;
  const PartnerNumbers rigid(snapshot.walls.size());
  for (const ContactState<dim> &contact : snapshot.contacts)
    if (contact.body_a >= snapshot.bodies.size() ||
        (contact.wall == none ? contact.body_b >= snapshot.bodies.size()
                              : !rigid.is_one(contact.wall, snapshot.obstacles.size())))
      throw ComputationError("a contact at t = " + std::to_string(snapshot.time) +
                             " s names a body or wall that is not there");
}
} // namespace

template <int dim>
MeasureSetIn<dim>::MeasureSetIn(const std::vector<std::string> &names)
{
  const Registry<MeasureIn<dim>> &known = Registry<MeasureIn<dim>>::instance();
  const bool all = std::find(names.begin(), names.end(), "all") != names.end();
  std::vector<std::string> taken;
  for (const std::string &name : all ? known.names() : names)
    if (std::find(taken.begin(), taken.end(), name) == taken.end())
    {
      measures.push_back(known.create(name));
      taken.push_back(name);
    }
}

template <int dim>
std::vector<std::string> MeasureSetIn<dim>::columns() const
{
  std::vector<std::string> result;
  for (const auto &measure : measures)
    for (const std::string &column : measure->columns())
      result.push_back(column);
  return result;
}

template <int dim>
std::vector<std::pair<std::string, MeasuredValue>>
MeasureSetIn<dim>::evaluate(const Snapshot<dim> &snapshot, const MeasureContextIn<dim> &context) const
{
  check(snapshot);
  const AssemblyIn<dim> assembly(snapshot, context);
  std::vector<std::pair<std::string, MeasuredValue>> result;
  for (const auto &measure : measures)
  {
    const std::vector<std::string> names = measure->columns();
    const std::vector<MeasuredValue> values = measure->evaluate(assembly);
    for (std::size_t i = 0; i < names.size(); ++i)
      result.emplace_back(names[i], values.at(i));
  }
  return result;
}

template <int dim>
std::vector<std::pair<std::string, MeasuredValue>>
MeasureSeriesIn<dim>::evaluate(const Snapshot<dim> &snapshot)
{
  MeasureContextIn<dim> context;
  context.first = first ? &*first : &snapshot;
  context.previous = previous ? &*previous : nullptr;
  context.friction = friction;
  auto values = set.evaluate(snapshot, context);
  remember(snapshot);
  return values;
}

template <int dim>
void MeasureSeriesIn<dim>::remember(const Snapshot<dim> &snapshot)
{
  Snapshot<dim> light;
  light.time = snapshot.time;
  light.step = snapshot.step;
  light.walls = snapshot.walls;
  light.obstacles = snapshot.obstacles;
  light.contacts = snapshot.contacts;
  light.bodies = snapshot.bodies;
  for (BodyState<dim> &body : light.bodies)
    body.outline.clear();
  if (!first)
    first = light;
  previous = std::move(light);
}

template class MeasureSetIn<2>;
template class MeasureSetIn<3>;
template class MeasureSeriesIn<2>;
template class MeasureSeriesIn<3>;
} // namespace softgrain
