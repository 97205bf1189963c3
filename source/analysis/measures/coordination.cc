// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/measure.h>
#include <softgrain/analysis/touching_pairs.h>

namespace softgrain
{
namespace
{
/**
 * @brief Contacts per body.
 *
 * A body with fewer than two contacts cannot be in equilibrium: it is a rattler, as are those that hang on
 * rattlers only.
 */
template <int dim>
class Coordination final : public MeasureIn<dim>
{
public:
  std::vector<std::string> columns() const override
  {
    return {"coordination", "coordination_of_bodies", "coordination_without_rattlers", "rattler_fraction"};
  }

  std::vector<MeasuredValue> evaluate(const AssemblyIn<dim> &assembly) const override
  {
    const std::size_t n = assembly.snapshot.bodies.size();
    if (n == 0)
      return {std::nullopt, std::nullopt, std::nullopt, std::nullopt};
    TouchingPairs pairs;
    double between_bodies = 0.;
    std::vector<unsigned int> degree(n, 0);
    std::vector<std::vector<unsigned int>> neighbours(n);
    for (const BodyContactIn<dim> &contact : assembly.contacts)
    {
      ++degree[contact.body_a];
      if (contact.with_wall())
      {
        pairs.add_wall(contact.body_a, contact.wall);
        continue;
      }
      pairs.add_bodies(contact.body_a, contact.body_b);
      ++degree[contact.body_b];
      between_bodies += 2.;
      neighbours[contact.body_a].push_back(contact.body_b);
      neighbours[contact.body_b].push_back(contact.body_a);
    }

    std::vector<bool> rattles(n, false);
    std::vector<unsigned int> open;
    for (unsigned int b = 0; b < n; ++b)
      if (degree[b] < 2)
        open.push_back(b);
    for (const unsigned int b : open)
      rattles[b] = true;
    std::size_t n_rattlers = open.size();
    while (!open.empty())
    {
      const unsigned int b = open.back();
      open.pop_back();
      for (const unsigned int neighbour : neighbours[b])
        if (!rattles[neighbour] && --degree[neighbour] < 2)
        {
          rattles[neighbour] = true;
          ++n_rattlers;
          open.push_back(neighbour);
        }
    }
    double kept = 0.;
    for (unsigned int b = 0; b < n; ++b)
      if (!rattles[b])
        kept += degree[b];
    const std::size_t n_kept = n - n_rattlers;
    return {pairs.coordination(n), between_bodies / n, n_kept > 0 ? kept / n_kept : 0.,
            static_cast<double>(n_rattlers) / n};
  }
};

constexpr const char *name = "coordination",
                     *description = "contacts per body, with and without walls and rattlers";
[[maybe_unused]] const bool registered = register_measure<Coordination<2>>(name, description),
                            registered_in_space = register_measure<Coordination<3>, 3>(name, description);
} // namespace
} // namespace softgrain
