// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_geometry_h
#define softgrain_mpm_contact_geometry_h

#include <softgrain/mpm/body.h>
#include <softgrain/mpm/contact_rows.h>

#include <vector>

namespace softgrain::mpm
{
/// What a search for contact rows looks at.
template <int dim>
struct ContactScene
{
  const std::vector<Body<dim>> &bodies;
  const std::vector<WallMotion<dim>> &walls;
  double friction;  ///< between bodies
  double dt;        ///< of the step to come [s]
  double cell_size; ///< [m]
};

/**
 * @brief Finds the rows at which bodies and walls may touch during a step.
 */
template <int dim>
class ContactGeometry
{
public:
  virtual ~ContactGeometry() = default;

  /// Rows for the positions at the start of the step, in an order that does not depend on the number of
  /// threads.
  virtual void find(const ContactScene<dim> &scene, std::vector<ContactRow<dim>> &rows) const = 0;
};
} // namespace softgrain::mpm

#endif
