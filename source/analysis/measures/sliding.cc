// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/measure.h>

#include <cmath>
#include <set>
#include <utility>

namespace softgrain
{
namespace
{
/// How much of the contacts between bodies is at the limit of Coulomb's law. Every row has a normal of its
/// own, so rows are looked at, not their sum.
class Sliding final : public Measure
{
public:
  std::vector<std::string> columns() const override { return {"sliding_contacts", "sliding_force"}; }

  std::vector<MeasuredValue> evaluate(const Assembly &assembly) const override
  {
    const std::optional<double> friction = assembly.context.friction;
    if (!friction || !(*friction > 0.))
      return {std::nullopt, std::nullopt};
    std::set<std::pair<unsigned int, unsigned int>> all, sticking;
    double normal = 0., at_limit = 0.;
    for (const ContactState<2> &row : assembly.snapshot.contacts)
    {
      const double pressed = row.force * row.normal;
      if (row.wall != ContactState<2>::not_a_body || row.body_a == row.body_b || !(pressed > 0.))
        continue;
      const auto pair = std::minmax(row.body_a, row.body_b);
      all.insert(pair);
      normal += pressed;
      if ((row.force - pressed * row.normal).norm() >= near_limit * *friction * pressed)
        at_limit += pressed;
      else
        sticking.insert(pair);
    }
    if (all.empty())
      return {std::nullopt, std::nullopt};
    return {1. - static_cast<double>(sticking.size()) / all.size(), at_limit / normal};
  }

private:
  static constexpr double near_limit = 0.99; ///< of friction times normal force: solvers have tolerances
};

[[maybe_unused]] const bool registered =
    register_measure<Sliding>("sliding", "share of contacts between bodies that slide");
} // namespace
} // namespace softgrain
