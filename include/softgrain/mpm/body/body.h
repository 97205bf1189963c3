// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_body_body_h
#define softgrain_mpm_body_body_h

#include <softgrain/constitutive/law.h>
#include <softgrain/geometry/periodic_cell.h>
#include <softgrain/mpm/body/body_points.h>
#include <softgrain/mpm/field/body_field.h>
#include <softgrain/scene/scene.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <Eigen/Core>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief The boundary of a body: closed polylines of markers that move with the field.
 *
 * Every `stride`-th marker is a sample of the outline where the search for contact looks; those between make
 * it smooth.
 */
template <int dim>
struct Boundary
{
  std::vector<dealii::Point<dim>> grid_position; ///< in the configuration of the grid [m]
  std::vector<dealii::Point<dim>> position;      ///< now [m]
  std::vector<unsigned int> loop_start;          ///< first marker of every closed loop, and the end
  unsigned int stride = 1;
  double spacing = 0.;      ///< of samples, at rest [m]
  std::vector<char> corner; ///< of every marker: whether the outline at rest has a corner there
  bool circular = false;    ///< a circle at rest, without a hole: turning it changes nothing

  unsigned int n_loops() const { return loop_start.empty() ? 0 : loop_start.size() - 1; }
  /// Marker after @p m in its loop.
  unsigned int next(const unsigned int m) const
  {
    const auto end = end_of_loop(m);
    return m + 1 == *end ? *(end - 1) : m + 1;
  }
  /// Marker before @p m in its loop.
  unsigned int previous(const unsigned int m) const
  {
    const auto end = end_of_loop(m);
    return m == *(end - 1) ? *end - 1 : m - 1;
  }

private:
  std::vector<unsigned int>::const_iterator end_of_loop(const unsigned int m) const
  {
    return loop_start.size() == 2 ? loop_start.begin() + 1
                                  : std::upper_bound(loop_start.begin(), loop_start.end(), m);
  }
};

/// What a body is made of.
template <int dim>
struct BodyMaterial
{
  std::shared_ptr<const constitutive::Law<dim>> law;
  double density = 0; ///< at rest [kg/m^3]
  /// Share of the dilatation that is averaged over cells (F-bar), against volumetric locking; 0: none.
  double averaged = 0.;

  bool small_strain() const { return law->kinematics() == constitutive::Kinematics::small_strain; }
};

/// What a body was before anything acted on it.
template <int dim>
struct BodyAtRest
{
  double area = 0;                          ///< [m^dim]
  std::vector<dealii::Point<dim>> position; ///< by number of the point, when a load needs it [m]
};

/// How a body moves that does not deform.
template <int dim>
struct RigidDrive
{
  bool driven = false;                               ///< whether it moves rigidly with `drive`
  dealii::Tensor<1, dim> drive;                      ///< velocity that it is given, in held steps apart [m/s]
  unsigned int wall = static_cast<unsigned int>(-1); ///< wall it stands for, if any
};

/**
 * @brief What the nodes of a body carry: vectors with dim components per independent node of its field.
 *
 * `displacement` runs from the configuration in which the grid was built, so that a grid may serve for one
 * step (updated Lagrangian) or for ever (total Lagrangian).
 */
template <int dim>
struct NodalState
{
  Eigen::VectorXd mass;               ///< per independent node, lumped (@cite nguyen2016, eq. (3.10)) [kg]
  Eigen::VectorXd displacement;       ///< since the grid was built [m]
  Eigen::VectorXd velocity;           ///< [m/s]; empty without inertia
  Eigen::VectorXd velocity_of_points; ///< what the points brought when the grid was built [m/s]; likewise
  /// What the time scheme keeps of the nodes from the last step, see TimeIntegrator::kept(): without inertia
  /// the mean velocity over the last one that was not held [m/s]; empty: there was none on this grid.
  Eigen::VectorXd kept;
  Eigen::VectorXd internal_force; ///< end of the last step [N]

  /// Momentum of the nodal field, zero where it has no velocity [kg m/s].
  dealii::Tensor<1, dim> momentum() const;
  double kinetic_energy() const; ///< likewise [J m^(dim-3)]
};

/// One body: its law, its points, its boundary and its nodal field.
template <int dim>
struct Body
{
  std::string name;
  unsigned int index = 0;
  BodyMaterial<dim> material;
  BodyAtRest<dim> rest;
  RigidDrive<dim> rigid;
  Loads<dim> loads; ///< of the scene and its own

  BodyPoints<dim> points;    ///< none when they lie with another owner
  unsigned int n_points = 0; ///< wherever they lie
  Boundary<dim> boundary;
  BodyField<dim> field;
  std::shared_ptr<const CellLevels<dim>> levels; ///< sizes of its cells; none: as the lattice has them
  NodalState<dim> nodes;

  /// Copy of the cell that repeats from which it has been brought to where it is.
  typename PeriodicCell<dim>::Image home{};

  /// Centre of mass [m].
  dealii::Point<dim> center() const;
  /// Takes it along as a whole, but for its boundary [m].
  void translate(const dealii::Tensor<1, dim> &way);
};
} // namespace softgrain::mpm

#endif
