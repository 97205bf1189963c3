// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_stress_h
#define softgrain_mpm_stepping_stress_h

#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/body/step_state.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace softgrain::mpm
{
/// How evaluate_stress() came out.
struct StressOutcome
{
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::size_t bad_point = none; ///< first point whose trial deformation is no good
  std::string place;            ///< of that point when its grid was laid, in words
  bool leaps = false;           ///< it is not inside out, but deforms by more than was allowed
  std::string refusal;          ///< what its law has against it, see constitutive::Refusal; mostly empty
  double share = 1.;            ///< of the step that the law allows, see constitutive::Outputs::step_share
  bool good() const { return bad_point == none; }
};

/// What evaluate_stress() is to do beside the stress.
struct Trial
{
  double half_dt = 0;   ///< dt/2 when volumes of small-strain laws follow @cite nguyen2016, eq. (3.17) within
                        ///< the step, 0: they stay [s]
  bool tangent = false; ///< add_stiffness() is to follow
  double max_strain = 0; ///< largest strain of any point over the step, see leaps(); 0: any
  double dt = 0;         ///< time that passes for the law, 0 where bodies only come to balance [s]
  double time = 0;       ///< at the end of the step [s]
};

/**
 * @brief Deformation and stress at all points for a trial displacement of the nodes, and what the law keeps
 * as history and dissipates on the way; a law without history dissipates nothing and is not asked.
 *
 * @param body         whose points they are
 * @param displacement of the independent nodes since the grid was laid [m]
 * @param increment    the part of it that belongs to this step [m]
 * @param trial        how far to go
 * @param s            is filled
 */
template <int dim>
StressOutcome evaluate_stress(const Body<dim> &body,
                              const Eigen::VectorXd &displacement,
                              const Eigen::VectorXd &increment,
                              const Trial &trial,
                              StepState<dim> &s);

/// What the state of a body tells beside its stress.
template <int dim>
struct PointMeasures
{
  double energy = 0;                       ///< stored in all points [J/m]
  std::vector<double> out_of_plane_stress; ///< per point, as the law returns it [Pa]
  /// F of every point as the stress sees it: with F-bar its dilatation is mostly that of the cell.
  std::vector<dealii::Tensor<2, dim>> gradient;
};

/**
 * @brief Measures of a body for a displacement of its nodes, the step state apart: no step needs them, so
 * they are computed when they are asked for. @p increment as in evaluate_stress(); zero for the present
 * state.
 */
template <int dim>
PointMeasures<dim>
measure_points(const Body<dim> &body, const Eigen::VectorXd &displacement, const Eigen::VectorXd &increment);

/// Internal force (@cite nguyen2016, eq. (3.11)) on the independent nodes for the stress last evaluated [N].
template <int dim>
void internal_force(const Body<dim> &body, StepState<dim> &s, Eigen::VectorXd &force);
} // namespace softgrain::mpm

#endif
