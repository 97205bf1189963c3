// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_hertz_dent_h
#define softgrain_mpm_contact_hertz_dent_h

namespace softgrain::mpm
{
/**
 * @brief The dent of a contact that is narrower than a cell: how much nearer a round body comes to a wall
 * than its grid says.
 *
 * Hertz's contact of radius a = (3 F R / 4 E*)^(1/3) gives way by a²/R. A grid with cells of edge h spreads
 * the force over about a cell, and shows β F / (E* h) of that. What is left of a narrow contact is
 * δ = F / (E* h) (3 h / 4 a - β), of a wider one F / (E* h) .127 (1 - a / 1.8 h)²: the larger of both,
 * or 0. β, .127 and 1.8 are measured, doc/results/three-dimensions.md. Below a force whose
 * contact is a twentieth of a cell wide the dent is linear, so that its slope stays finite.
 */
class HertzDent
{
public:
  /// No dent.
  HertzDent() = default;
  /// @param modulus E/(1 - ν²) [Pa]
  HertzDent(double modulus, double radius, double cell_size, double beta = 1.1);

  /// δ for a force, not negative [m].
  double operator()(double force) const;
  /// δ/F; of the smallest contact where there is no force [m/N]
  double per_force(double force) const;
  /// dδ/dF [m/N]
  double slope(double force) const;
  /// Work of a force on the way to it [J]; below zero when the contact is wide, for δ falls again.
  double energy(double force) const;

private:
  /// Radius of a contact under a force [m].
  double radius_of_contact(double force) const;
  /// Force of a contact [N].
  double force_of(double a) const;
  /// F dδ from no force on, of the laws of a narrow and of a wide contact [J].
  double narrow_work(double force) const;
  double wide_work(double force) const;

  double modulus = 0., radius = 0., cell_size = 0., beta = 0., smallest = 0., of_smallest = 0.;
  double wide_from = 0., ends_at = 0.; ///< radii of contact at which the second law begins, and ends [m]
};
} // namespace softgrain::mpm

#endif
