// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/box_measures.h>
#include <softgrain/analysis/measure.h>
#include <softgrain/analysis/snapshot_cell.h>

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
Pairs pairs_of(const std::vector<BodyContact> &contacts)
{
  Pairs pairs;
  for (const BodyContact &contact : contacts)
    if (!contact.with_wall())
      pairs.emplace(contact.body_a, contact.body_b);
  return pairs;
}

double members_only_of(const Pairs &one, const Pairs &other)
{
  return std::count_if(one.begin(), one.end(), [&other](const auto &pair) { return other.count(pair) == 0; });
}

/// What bodies did since the snapshot before beside following the box: contacts that came and went, and ways
/// that are not affine.
class Rearrangements final : public Measure
{
public:
  std::vector<std::string> columns() const override
  {
    return {"contacts_won_per_strain", "contacts_lost_per_strain", "nonaffine_displacement",
            "nonaffine_displacement_per_strain"};
  }

  std::vector<MeasuredValue> evaluate(const Assembly &assembly) const override
  {
    std::vector<MeasuredValue> result(4);
    const Snapshot<2> *const before = assembly.context.previous;
    if (before == nullptr || before->bodies.size() != assembly.snapshot.bodies.size())
      return result;
    const auto strain = box_strain(before->walls, assembly.snapshot.walls);
    if (!strain || assembly.snapshot.bodies.empty())
      return result;
    // The shear strain of a box that keeps its area, the change of area of one that keeps its form.
    const double way = std::abs(strain->along_height) + std::abs(strain->along_width) +
                       sheared(before->walls, assembly.snapshot.walls);
    const Pairs old_pairs = pairs_of(Assembly(*before).contacts), pairs = pairs_of(assembly.contacts);
    result[2] = nonaffine_displacement(assembly, *before, *strain);
    if (!(way > 0.))
      return result;
    if (!old_pairs.empty())
    {
      result[0] = members_only_of(pairs, old_pairs) / old_pairs.size() / way;
      result[1] = members_only_of(old_pairs, pairs) / old_pairs.size() / way;
    }
    result[3] = *result[2] / way;
    return result;
  }

private:
  /// Shear strain of a cell whose top slides over its bottom.
  static double sheared(const std::vector<WallState<2>> &before, const std::vector<WallState<2>> &now)
  {
    const PeriodicCell<2> old_cell = cell_of(before), cell = cell_of(now);
    return cell.repeats() ? std::abs(cell.offset / cell.length[1] - old_cell.offset / old_cell.length[1])
                          : 0.;
  }

  /// Root of the mean square, over the mean diameter.
  static double
  nonaffine_displacement(const Assembly &assembly, const Snapshot<2> &before, const BoxStrain &strain)
  {
    const auto corner = [](const std::vector<WallState<2>> &walls)
    {
      const WallState<2> &left = *find_wall(walls, "left"), &bottom = *find_wall(walls, "bottom");
      return dealii::Point<2>(left.point * left.normal * left.normal[0],
                              bottom.point * bottom.normal * bottom.normal[1]);
    };
    const dealii::Point<2> old_corner = corner(before.walls), new_corner = corner(assembly.snapshot.walls);
    const double stretch[2] = {std::exp(-strain.along_width), std::exp(-strain.along_height)};
    const PeriodicCell<2> old_cell = cell_of(before.walls), cell = cell_of(assembly.snapshot.walls);
    const double shear = (cell.offset - stretch[0] * old_cell.offset) / old_cell.length[1];
    double sum = 0., diameter = 0.;
    for (unsigned int b = 0; b < before.bodies.size(); ++b)
    {
      dealii::Tensor<1, 2> way;
      for (unsigned int d = 0; d < 2; ++d)
      {
        const double affine = new_corner[d] + stretch[d] * (before.bodies[b].center[d] - old_corner[d]);
        way[d] = assembly.snapshot.bodies[b].center[d] - affine;
      }
      if (cell.repeats())
      {
        way[0] -= shear * (before.bodies[b].center[1] - old_corner[1]);
        way = cell.shortest(way);
      }
      for (unsigned int d = 0; d < 2; ++d)
        sum += std::pow(way[d], 2);
      diameter += assembly.rest_diameter(b);
    }
    const double n = before.bodies.size();
    return std::sqrt(sum / n) / (diameter / n);
  }
};

[[maybe_unused]] const bool registered = register_measure<Rearrangements>(
    "rearrangements",
    "contacts won and lost, and ways that do not follow the box, since the snapshot before");
} // namespace
} // namespace softgrain
