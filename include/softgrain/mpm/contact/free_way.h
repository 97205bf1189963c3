// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_free_way_h
#define softgrain_mpm_contact_free_way_h

#include <softgrain/driving/cell_motion.h>
#include <softgrain/mpm/contact/frame_state.h>
#include <softgrain/mpm/contact/free_walls.h>

#include <array>
#include <optional>

namespace softgrain::mpm
{
/**
 * @brief How far a wall under a load goes in a step: one unknown of Newton's equations.
 *
 * The load bears what the rays give, and a spring that resists the way: without inertia a weak one, with
 * inertia that of its mass, and the load holds what the wall has of speed. A wall goes no further than its
 * stop.
 */
template <int dim>
struct FreeWay
{
  using Vector = dealii::Tensor<1, dim>;

  /// @param free of the step
  /// @param slab body that the wall is made of; none: it is a plane, or a side of a cell
  /// @param cell as it is at the start of the step, of a wall that is a side of it
  /// @param net    force with which it begins: it sets out for its stop on that side; 0: it is free [N/m]
  /// @param load   along its way [N/m]
  /// @param limit of its way [m]
  /// @param stiffness of the spring [N/m^2]
  FreeWay(const FreeWall<dim> &free,
          unsigned int slab,
          const PeriodicCell<dim> *cell,
          double net,
          double load,
          double limit,
          double stiffness);

  /// A wall with inertia: a spring stands for its mass, and it sets out with the speed that it has.
  static FreeWay with_mass(
      const FreeWall<dim> &free, unsigned int slab, const PeriodicCell<dim> *cell, double theta, double dt);

  /// Ways of the partner, or the wall, and of the body of a frame per unit of the way.
  std::array<Vector, 2> moves(const FrameScene<dim> &scene, const FrameState<dim> &frame) const;

  /// Whether bodies go with the wall, as with a slab or a side of a cell; a plane goes alone.
  bool carries() const { return cell.has_value() || slab != FrameState<dim>::none; }

  int stopped = 0;      ///< 0: it is free; 1 or -1: it stands at its stop on that side
  double at = 0;        ///< how far it has gone [m]
  double load = 0;      ///< along its way [N/m]
  double stiffness = 0; ///< of the spring [N/m^2]
  double limit = 0;     ///< of the way [m]

private:
  unsigned int wall, slab;
  Vector way;
  std::optional<CellMotion<dim>> cell; ///< motion of the cell per unit of the way
};
} // namespace softgrain::mpm

#endif
