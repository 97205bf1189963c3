// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/measure.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace softgrain
{
namespace
{
using Pairs = std::set<std::pair<unsigned int, unsigned int>>;

/// Bodies that touch each other.
Pairs pairs_of(const AssemblyIn<3> &assembly)
{
  Pairs pairs;
  for (const BodyContactIn<3> &contact : assembly.contacts)
    if (!contact.with_wall())
      pairs.emplace(contact.body_a, contact.body_b);
  return pairs;
}

double members_only_of(const Pairs &one, const Pairs &other)
{
  return std::count_if(one.begin(), one.end(), [&other](const auto &pair) { return other.count(pair) == 0; });
}

/// Corner of the box with the smallest coordinates.
dealii::Point<3> corner_of(const std::vector<WallState<3>> &walls)
{
  dealii::Point<3> corner;
  for (unsigned int d = 0; d < 3; ++d)
    corner[d] = find_wall(walls, Box<3>::sides[2 * d])->point[d];
  return corner;
}

/// What bodies in space did since the snapshot before beside following the box: contacts that came and went,
/// and ways that are not affine.
class RearrangementsInSpace final : public MeasureIn<3>
{
public:
  std::vector<std::string> columns() const override
  {
    return {"contacts_won_per_strain", "contacts_lost_per_strain", "nonaffine_displacement",
            "nonaffine_displacement_per_strain"};
  }

  std::vector<MeasuredValue> evaluate(const AssemblyIn<3> &assembly) const override
  {
    std::vector<MeasuredValue> result(4);
    const Snapshot<3> *const before = assembly.context.previous;
    const std::size_t n = assembly.snapshot.bodies.size();
    if (before == nullptr || before->bodies.size() != n || n == 0 || !assembly.box)
      return result;
    const AssemblyIn<3> old(*before);
    if (!old.box)
      return result;
    const dealii::Point<3> from = corner_of(before->walls), to = corner_of(assembly.snapshot.walls);
    double way = 0., sum = 0., diameter = 0.;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double stretch = assembly.box->edge[d] / old.box->edge[d];
      way += std::abs(std::log(stretch));
      for (unsigned int b = 0; b < n; ++b)
        sum += std::pow(assembly.snapshot.bodies[b].center[d] - to[d] -
                            stretch * (before->bodies[b].center[d] - from[d]),
                        2);
    }
    for (unsigned int b = 0; b < n; ++b)
      diameter += assembly.rest_diameter(b) / n;
    result[2] = std::sqrt(sum / n) / diameter;
    if (!(way > 0.))
      return result;
    const Pairs old_pairs = pairs_of(old), pairs = pairs_of(assembly);
    if (!old_pairs.empty())
    {
      result[0] = members_only_of(pairs, old_pairs) / old_pairs.size() / way;
      result[1] = members_only_of(old_pairs, pairs) / old_pairs.size() / way;
    }
    result[3] = *result[2] / way;
    return result;
  }
};

[[maybe_unused]] const bool registered = register_measure<RearrangementsInSpace, 3>(
    "rearrangements",
    "contacts won and lost, and ways that do not follow the box, since the snapshot before");
} // namespace
} // namespace softgrain
