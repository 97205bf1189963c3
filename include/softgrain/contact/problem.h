// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_problem_h
#define softgrain_contact_problem_h

#include <vector>

namespace softgrain::contact
{
/**
 * @brief What a contact problem knows beside its Delassus operator W.
 *
 * Find the impulses P (N s, in plane strain N s per metre of thickness) with relative velocities w = W P + q
 * such that in every contact `0 <= P_n ⟂ w_n >= 0` (Signorini at velocity level) and `|P_t| <= mu P_n`, with
 * `P_t = -mu P_n w_t / |w_t|` when it slides (Coulomb, not associated). Components of contact i are at
 * `i * n_components`: the normal first (positive when the pair separates), then the tangents.
 *
 * Where a contact is held together by a cohesive impulse c, P_n + c takes the place of P_n in these
 * conditions: the same cone, shifted along the normal.
 */
struct Problem
{
  /// Components of a contact: 1 frictionless, 2 friction in the plane, 3 friction in space.
  unsigned int n_components = 1;

  /// Relative velocity q without contact impulses, gap term included (m/s); n_contacts * n_components values.
  std::vector<double> free_velocity;

  /// Friction coefficient of every contact; may be empty when n_components is 1, where it is not read.
  std::vector<double> friction;

  /// Contacts first, ..., end - 1.
  struct Range
  {
    unsigned int first, end;
  };

  /// All contacts, as ranges by colour: those of a colour share no unknown of the operator (for bodies: no
  /// body), so they are solved at the same time, and the order does not depend on the number of threads.
  /// Empty: one contact after the other.
  std::vector<std::vector<Range>> colors = {};

  /// Cohesive impulse c of every contact (N s); empty: none.
  std::vector<double> cohesion = {};

  /// Number of contacts that @p free_velocity describes.
  unsigned int n_contacts() const { return n_components == 0 ? 0 : free_velocity.size() / n_components; }

  /// Friction coefficient of @p contact, 0 in a frictionless problem.
  double friction_of(const unsigned int contact) const { return n_components == 1 ? 0. : friction[contact]; }

  /**
   * @brief Checks sizes and values.
   * @throw InputError when sizes do not fit, or a friction coefficient or a cohesive impulse is negative.
   * @throw ComputationError when a velocity, a friction coefficient or a cohesive impulse is not finite.
   */
  void check() const;
};
} // namespace softgrain::contact

#endif
