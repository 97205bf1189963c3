// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/measure.h>
#include <softgrain/base/exceptions.h>

#include <algorithm>
#include <cmath>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::Measure)

namespace softgrain
{
namespace
{
/// Measures divide by areas and look up bodies, so both are verified once for all of them.
void check(const Snapshot<2> &snapshot)
{
  for (const BodyState<2> &body : snapshot.bodies)
    if (!(body.area > 0.) || !(body.reference_area > 0.) || body.outline.empty())
      throw ComputationError("body '" + body.name + "' has no outline or no area at t = " +
                             std::to_string(snapshot.time) + " s: nothing can be measured");
  constexpr unsigned int none = ContactState<2>::not_a_body;
  for (const ContactState<2> &contact : snapshot.contacts)
    if (contact.body_a >= snapshot.bodies.size() ||
        (contact.wall == none ? contact.body_b >= snapshot.bodies.size()
                              : contact.wall >= snapshot.walls.size() + snapshot.obstacles.size()))
      throw ComputationError("a contact at t = " + std::to_string(snapshot.time) +
                             " s names a body or wall that is not there");
}
} // namespace

MeasureSet::MeasureSet(const std::vector<std::string> &names)
{
  const Registry<Measure> &known = Registry<Measure>::instance();
  const bool all = std::find(names.begin(), names.end(), "all") != names.end();
  std::vector<std::string> taken;
  for (const std::string &name : all ? known.names() : names)
    if (std::find(taken.begin(), taken.end(), name) == taken.end())
    {
      measures.push_back(known.create(name));
      taken.push_back(name);
    }
}

std::vector<std::string> MeasureSet::columns() const
{
  std::vector<std::string> result;
  for (const auto &measure : measures)
    for (const std::string &column : measure->columns())
      result.push_back(column);
  return result;
}

std::vector<std::pair<std::string, MeasuredValue>> MeasureSet::evaluate(const Snapshot<2> &snapshot,
                                                                        const MeasureContext &context) const
{
  check(snapshot);
  const Assembly assembly(snapshot, context);
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

std::vector<std::pair<std::string, MeasuredValue>> MeasureSeries::evaluate(const Snapshot<2> &snapshot)
{
  MeasureContext context;
  context.first = first ? &*first : &snapshot;
  context.previous = previous ? &*previous : nullptr;
  context.friction = friction;
  auto values = set.evaluate(snapshot, context);
  remember(snapshot);
  return values;
}

void MeasureSeries::remember(const Snapshot<2> &snapshot)
{
  Snapshot<2> light;
  light.time = snapshot.time;
  light.step = snapshot.step;
  light.walls = snapshot.walls;
  light.obstacles = snapshot.obstacles;
  light.contacts = snapshot.contacts;
  light.bodies = snapshot.bodies;
  for (BodyState<2> &body : light.bodies)
    body.outline.clear();
  if (!first)
    first = light;
  previous = std::move(light);
}
} // namespace softgrain
