// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_analysis_snapshot_h
#define softgrain_analysis_snapshot_h

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace softgrain
{
/// A named scalar per point or per body, for pictures; the name carries its unit, as in `pressure_Pa`.
struct NamedField
{
  std::string name;
  std::vector<double> values;
};

/// Material points or primaries: one entry of every vector per point, in an order that does not change with
/// the step.
template <int dim>
struct PointStates
{
  std::vector<dealii::Point<dim>> position;            ///< current place [m]
  std::vector<unsigned int> body;                      ///< index into Snapshot::bodies
  std::vector<double> size;                            ///< current volume (area in 2D) of the point [m^dim]
  std::vector<dealii::Tensor<1, dim>> velocity;        ///< [m/s]
  std::vector<dealii::SymmetricTensor<2, dim>> stress; ///< Cauchy stress, tension positive [Pa]
  std::vector<double> out_of_plane_stress;             ///< sigma_zz, plane strain only [Pa]
  std::vector<dealii::Tensor<2, dim>> deformation_gradient; ///< F from the stress-free state (may be empty)
  std::vector<NamedField> extra;                            ///< history of the law and the like
};

/// One body (grain): what every measure needs of it.
template <int dim>
struct BodyState
{
  std::string name;
  std::vector<std::vector<dealii::Point<dim>>>
      outline; ///< closed polylines, the outer one first, counter-clockwise [m]
  /// Triangles of the surface in space, counter-clockwise from outside; the first outline lists vertices.
  std::vector<std::array<unsigned int, 3>> triangles;
  double area = 0;                 ///< current area enclosed by the outline, in space volume [m^dim]
  double reference_area = 0;       ///< the same at rest [m^dim]
  double mass = 0;                 ///< [kg/m in 2D]
  dealii::Point<dim> center;       ///< centre of mass [m]
  dealii::Tensor<1, dim> velocity; ///< of the centre of mass [m/s]
  double angular_momentum = 0;     ///< about the centre of mass [kg m/s]
  dealii::SymmetricTensor<2, dim> mean_stress; ///< volume mean of the Cauchy stress [Pa]
  double curvature = 0;                        ///< 1/R at rest of a disk whose law is known; 0: none [1/m]
  double compliance = 0; ///< (1-nu^2)/E of a disk whose law is known, 0 of a rigid one [1/Pa]
};

/// A force between two bodies, or a body and a wall, at one place.
template <int dim>
struct ContactState
{
  static constexpr unsigned int not_a_body = static_cast<unsigned int>(-1);

  unsigned int body_a = not_a_body; ///< the body that feels `force`
  unsigned int body_b = not_a_body; ///< its partner, or not_a_body when it is a wall
  unsigned int wall = not_a_body;   ///< index into Snapshot::walls, those of obstacles follow; or not_a_body
  dealii::Point<dim> place;         ///< [m]
  dealii::Tensor<1, dim> normal;    ///< unit, from partner to body_a
  dealii::Tensor<1, dim> force;     ///< on body_a [N/m in 2D]
  double length = 0;                ///< length of contact line this row stands for [m]
  double gap = 0;                   ///< [m], negative when the bodies overlap
  dealii::Tensor<1, dim> image;     ///< from body_b to the image of it that body_a touches [m]
};

/// A wall and what it feels.
template <int dim>
struct WallState
{
  std::string name;
  dealii::Point<dim> point;      ///< a point of its plane [m]
  dealii::Tensor<1, dim> normal; ///< unit, into the domain
  double position = 0;           ///< that `NAME_position_m` reports, see wall_position() [m]
  double velocity = 0;           ///< along the normal [m/s]
  double slide_velocity = 0;     ///< along the tangent (normal turned by -90 degrees) [m/s]
  double normal_force = 0;       ///< compression positive [N/m in 2D]
  double tangential_force = 0;   ///< force on the wall along its tangent (normal turned by -90 degrees) [N/m]
  bool repeats = false;          ///< it is a side of a cell that repeats: forces are those through it
  double offset = 0;             ///< of the cell above, of such a side [m]
};

/// A rigid line of finite length, in space a sheet, and what it feels.
template <int dim>
struct ObstacleState
{
  std::string name;
  /// Where it is, arcs as polylines; in space the corners of its triangles [m].
  std::vector<dealii::Point<dim>> line;
  std::vector<std::array<unsigned int, 3>> triangles; ///< in space
  dealii::Point<dim> pivot;                           ///< where it is [m]
  double angle = 0;             ///< by which it has turned, counter-clockwise about its axis [rad]
  dealii::Tensor<1, dim> force; ///< on it [N/m in 2D]
  double torque = 0;            ///< of these forces about the axis through the pivot [N in 2D]
};

/// Energies of the whole scene [J/m in 2D].
struct Energies
{
  double kinetic = 0;
  double elastic = 0;
  double dissipated = 0;    ///< by friction, inelastic contact and the laws, since the start
  double external_work = 0; ///< done by walls, body forces and adhesion since the start
};

/**
 * @brief The state of a scene, the same for every model: all measures, pictures and files are made from it.
 */
template <int dim>
struct Snapshot
{
  double time = 0; ///< [s]
  std::uint64_t step = 0;
  PointStates<dim> points;
  std::vector<BodyState<dim>> bodies;
  std::vector<WallState<dim>> walls;
  std::vector<ObstacleState<dim>> obstacles;
  std::vector<ContactState<dim>> contacts; ///< only those that carry force
  Energies energies;
};
} // namespace softgrain

#endif
