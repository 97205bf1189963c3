// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_subgrid_compliance_h
#define softgrain_mpm_contact_subgrid_compliance_h

#include <softgrain/mpm/body/body.h>

#include <array>

namespace softgrain::mpm
{
/**
 * @brief What a grid cannot resolve of the dent of a light contact.
 *
 * Two round bodies that touch on a width 2a dent each other by an amount that grows with the logarithm of R/a
 * (Johnson, Contact Mechanics, 1985, section 5.6). A grid of cells h sees the dent from about a = h on; of a
 * narrower contact it misses, per body, the approach
 *
 *     δ = F 2/(π E*) g(a/h),    E* = E/(1-ν²),    a² = 4 F R/(π E*)
 *
 * with the force F per length of the contact [N/m], and in a² the sums 1/R and 1/E* of both sides. g is one
 * function for all h and every body, g = ln(k h/a) where that is positive: the grid puts a line force on a
 * width of about a cell. How wide, k, depends on Poisson's ratio, on the angle between the outline and the
 * lines of the grid, and on where between two of them the contact is; it is measured
 * (doc/results/rim.md), like the constants of a law of the wall for turbulence. It belongs to quadratic
 * B-splines and to round bodies; other bodies have none. Along the contact nothing is added.
 */
struct SubgridCompliance
{
  bool on = false;
  double cell_size = 0;           ///< [m]
  dealii::Point<2> lattice_lower; ///< where lines of the grid cross [m]

  /// Whether what the grid misses of its dents is known.
  static bool is_round(const Body<2> &body) { return body.boundary.circular && !body.rigid.driven; }

  /**
   * ln k at a place of the outline of a round body.
   * @param place  in the configuration of the grid [m]
   * @param normal of the outline there, unit
   */
  double log_full_width(double poisson_ratio,
                        const dealii::Point<2> &place,
                        const dealii::Tensor<1, 2> &normal) const;

  /// What the grid misses of a contact: δ = C F ln(F_full/F)/2 up to F_full.
  struct Dent
  {
    double compliance = 0.; ///< C [m^2/N]; 0: nothing is missed
    double full_force = 0.; ///< from which on the grid sees the whole dent [N/m]
  };
  /// Dent of the contact of @p body with @p partner, or with a rigid plane when that is null;
  /// @p log_full_width of both where they touch.
  Dent dent(const Body<2> &body, const Body<2> *partner, const std::array<double, 2> &log_full_width) const;

  /// Approach per force that the grid misses under @p force [N/m]; [m^2/N]
  double operator()(const Dent &dent, double force) const;

  /// dδ/dF [m^2/N].
  double slope(const Dent &dent, double force) const;

  /// Energy in the dents that the grid misses of such a contact, the work of the force on the way to it;
  /// below zero when the contact is wide, for δ falls again under larger forces [J/m].
  double energy(const Dent &dent, double force) const;
};
} // namespace softgrain::mpm

#endif
