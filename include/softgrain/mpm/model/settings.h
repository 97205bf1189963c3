// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_settings_h
#define softgrain_mpm_model_settings_h

#include <softgrain/contact/gauss_seidel.h>
#include <softgrain/driving/step_control.h>
#include <softgrain/linear/linear_solver.h>
#include <softgrain/mpm/stepping/time_scheme.h>

#include <deal.II/base/point.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain::mpm
{
/// When the background grid is laid anew under the points.
enum class GridUpdate
{
  never,      ///< the grid moves with the body for ever: total Lagrangian
  every_step, ///< updated Lagrangian, the usual MPM and the thesis
  distortion  ///< when the grid under some point is more distorted than a limit
};

/// How contact and bulk are brought together.
enum class ContactCoupling
{
  condensed, ///< W = H A^-1 H^T, one solve per Newton iteration
  lumped     ///< W = H M^-1 H^T, iterated with Newton (thesis, 3.27-3.30)
};

/// Everything that says how MPM solves a scene, as read from a parameter file.
struct Settings
{
  dealii::Point<2> mesh_lower, mesh_upper;   ///< [m]
  dealii::Point<3> space_lower, space_upper; ///< the same where the dimension is 3 [m]
  double cell_size = 0;                      ///< of the largest cells [m]
  unsigned int refine_near_contact = 0;      ///< levels of smaller cells there

  std::string shape = "bspline";
  unsigned int points_per_direction = 2;
  double fill_limit = 0.6;
  GridUpdate grid_update = GridUpdate::never;
  double distortion_limit = 3.; ///< ratio of the largest to the smallest stretch of the grid
  bool affine_transfer = false; ///< APIC
  double pic_fraction = 0.;
  std::string f_bar = "automatic";

  double theta = 0.; ///< as asked for; 0: chosen by the length of the steps
  TimeScheme scheme;
  StepSettings step;
  double cfl_multiple = 20.; ///< length of a step in CFL steps, when none is given
  double wall_way = 0.;      ///< of the fastest wall in a step [cells]; 0: steps do not depend on walls
  bool chosen_way = false;   ///< whether that is not from the file, see choose_steps()

  double displacement_tolerance = 1e-5; ///< epsilon_1 of @cite nguyen2016, eq. (3.22)
  double energy_tolerance = 1e-8;       ///< epsilon_2 of @cite nguyen2016, eq. (3.22)
  double residual_tolerance = 1e-5;
  unsigned int max_newton = 25;
  double max_strain = 0.3; ///< of any material point in one implicit step

  LinearSolverSettings linear_solver;

  std::string contact_geometry = "rays"; ///< member of ContactGeometryKind
  bool by_rays = true;                   ///< what that says
  ContactCoupling coupling = ContactCoupling::condensed;
  bool nodal_gap = true;
  double marker_spacing = 0.5;      ///< [cells]
  double largest_penetration = 0.1; ///< at the end of a step [cells]
  bool subgrid = true;              ///< see SubgridCompliance
  contact::SolverSettings contact_solver;
  std::string failed_problem_directory; ///< where contact problems that do not converge are kept

  double regularisation = 1e-4;      ///< of quasi_static, see StepPlan
  double unbalanced_force = 1e-4;    ///< net force on a body over the mean contact force, in balance
  unsigned int max_held_steps = 200; ///< after one that moves
  double wall_motion = 0.3;          ///< of a wall under pressure, in a step or a held step at most [cells]

  /// Edge of the smallest cells, those of the lattice [m].
  double finest_cell() const { return std::ldexp(cell_size, -static_cast<int>(refine_near_contact)); }

  /// Whether dilatations are averaged over cells (F-bar) for a law with this Poisson's ratio.
  bool averages_dilatations(const double poisson_ratio) const
  {
    return f_bar == "on" || (f_bar == "automatic" && poisson_ratio > 0.47);
  }

  /// Which share of them is averaged, 0 to 1. The rest holds the points of a cell together, with three times
  /// the shear modulus at most: a law with lambda = 3 mu does not lock.
  double averaged_dilatation(const double poisson_ratio) const
  {
    if (!averages_dilatations(poisson_ratio))
      return 0.;
    return 1. - std::min(0.3, 3. * (1. - 2. * poisson_ratio) / (2. * std::max(poisson_ratio, 0.1)));
  }

  /// Whether what the grid misses of light contacts is added: it is measured for B-splines.
  bool subgrid_compliance() const { return subgrid && scheme.ends_in_balance() && shape == "bspline"; }

  /// Whether contact is solved with what the matrices of bodies say of their rows, else with nodal masses.
  bool condenses() const { return scheme.solves_equations() && coupling == ContactCoupling::condensed; }

  /// Whether surfaces are met by rays, see ContactFrame.
  bool meets_by_rays() const { return by_rays; }

  /// Whether contact follows bodies through a step: rays of an implicit one see all that bodies come to meet;
  /// other rows are those of its start or its middle.
  bool follows_contact() const { return by_rays && scheme.solves_equations(); }

  /// Declares the sections Mesh, Material points, Time, Newton, Linear solver and the rest of Contact.
  static void declare_parameters(dealii::ParameterHandler &prm);
  /// @param dimension 2 or 3
  /// @throw InputError for values that do not fit together
  void parse_parameters(dealii::ParameterHandler &prm, unsigned int dimension = 2);

private:
  /// The handler stands in section Mesh.
  void parse_mesh(const dealii::ParameterHandler &prm, unsigned int dimension);
};
} // namespace softgrain::mpm

#endif
