// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_contact_geometry_h
#define softgrain_mpm_contact_contact_geometry_h

#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/contact/contact_rows.h>
#include <softgrain/scene/contact_pairs.h>

#include <vector>

namespace softgrain::mpm
{
/// What a search for contact rows looks at.
template <int dim>
struct ContactScene
{
  const std::vector<Body<dim>> &bodies;
  const std::vector<WallMotion<dim>> &walls;
  const ContactPairs &pairs; ///< what they do to each other
  double dt;                 ///< of the step to come [s]
  double cell_size;          ///< [m]
};

/// Gives a row what the two that meet there do to each other.
template <int dim>
void take_pair(const ContactScene<dim> &scene, ContactRow<dim> &row)
{
  const bool wall = row.wall != ContactRow<dim>::none;
  row.law.friction =
      wall ? scene.pairs.friction_at_wall(row.body, row.wall) : scene.pairs.friction(row.body, row.partner);
  row.law.adhesion =
      wall ? scene.pairs.adhesion_at_wall(row.body, row.wall) : scene.pairs.adhesion(row.body, row.partner);
}

/**
 * @brief Finds the rows at which bodies and walls may touch during a step.
 */
template <int dim>
class ContactGeometry
{
public:
  virtual ~ContactGeometry() = default;

  /// Rows with the gaps that they have at the start of the step, in an order that does not depend on the
  /// number of threads. Every owner finds those of all bodies.
  virtual void find(const ContactScene<dim> &scene, std::vector<ContactRow<dim>> &rows) const = 0;
};
} // namespace softgrain::mpm

#endif
