// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_hertz_compliance_h
#define softgrain_mpm_contact_hertz_compliance_h

#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/contact/hertz_dent.h>

#include <array>

namespace softgrain::mpm
{
/**
 * @brief What SubgridCompliance is in the plane, in space: what a grid cannot resolve of the dent where two
 * balls touch, or a ball and a plane.
 *
 * A contact is seen whole from a radius a = k h on. k depends on where in its cell the contact is; it is
 * measured, doc/results/three-dimensions.md. It belongs to quadratic B-splines.
 */
struct HertzCompliance
{
  bool on = false;
  double cell_size = 0;           ///< [m]
  dealii::Point<3> lattice_lower; ///< where lines of the grid cross [m]

  static bool is_round(const Body<3> &body) { return body.boundary.circular && !body.rigid.driven; }

  /// ln k at a place of the surface of a ball. @param place in the configuration of the grid [m]
  /// @param normal of the surface there, unit
  double log_full_width(double poisson_ratio,
                        const dealii::Point<3> &place,
                        const dealii::Tensor<1, 3> &normal) const;

  using Dent = HertzDent;
  /// Dent of the contact of @p body with @p partner, or with a rigid plane when that is null;
  /// @p log_full_width of both where they touch.
  Dent dent(const Body<3> &body, const Body<3> *partner, const std::array<double, 2> &log_full_width) const;

  /// Approach per force that the grid misses under @p force [m/N].
  double operator()(const Dent &dent, const double force) const { return dent.per_force(force); }
  /// dδ/dF [m/N].
  double slope(const Dent &dent, const double force) const { return dent.slope(force); }
  /// Energy in a dent [J].
  double energy(const Dent &dent, const double force) const { return dent.energy(force); }
};
} // namespace softgrain::mpm

#endif
