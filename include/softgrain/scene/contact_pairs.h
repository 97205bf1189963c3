// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_contact_pairs_h
#define softgrain_scene_contact_pairs_h

#include <softgrain/scene/scene.h>

#include <optional>
#include <string>
#include <vector>

namespace softgrain
{
/// Whether something in @p scene names friction, before its bodies are known.
bool has_friction(const Scene<2> &scene);

/// What rubs in @p scene and what does not, for the user: "0.5 between bodies, none at bottom, top".
std::string friction_in_words(const Scene<2> &scene);

/// Friction of every contact between bodies, if it is that of Coulomb's law and the same for all.
std::optional<double> uniform_friction(const Scene<2> &scene);

/**
 * @brief Friction and strength of adhesion of every pair of bodies, and of bodies with walls, in both models.
 *
 * Where several entries of a table fit a pair, the one that names most bodies counts. Bodies that no entry
 * tells apart share a row of a small matrix, so a packing of any size needs no more than one of two bodies.
 */
class ContactPairs
{
public:
  /// Bodies that meet nothing with friction or adhesion.
  ContactPairs() = default;

  /// @throw InputError when two entries that fit a pair equally well differ
  template <int dim>
  explicit ContactPairs(const Scene<dim> &scene);

  double friction(const unsigned int a, const unsigned int b) const { return value(frictions, a, b); }
  double friction_at_wall(const unsigned int body, const unsigned int wall) const
  {
    return at_wall(frictions, body, wall);
  }

  /// [N/m^2] with material points, [N/m] per contact of primaries
  double adhesion(const unsigned int a, const unsigned int b) const { return value(adhesions, a, b); }
  double adhesion_at_wall(const unsigned int body, const unsigned int wall) const
  {
    return at_wall(adhesions, body, wall);
  }

  /// Whether no body can meet anything with friction.
  bool frictionless() const { return !any_friction; }
  /// Whether some bodies may be held by what they meet.
  bool adhere() const { return any_adhesion; }

private:
  double value(const std::vector<double> &of, const unsigned int a, const unsigned int b) const
  {
    return of.empty() ? 0. : of[group[a] * columns + group[b]];
  }
  double at_wall(const std::vector<double> &of, const unsigned int body, const unsigned int wall) const
  {
    return of.empty() ? 0. : of[group[body] * columns + n_groups + wall];
  }

  std::vector<unsigned int> group; ///< of every body
  unsigned int n_groups = 0, columns = 0;
  std::vector<double> frictions, adhesions; ///< group by (group, then wall); empty: 0 everywhere
  bool any_friction = false, any_adhesion = false;
};
} // namespace softgrain

#endif
