// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_free_walls_h
#define softgrain_mpm_contact_free_walls_h

#include <softgrain/contact/block_delassus.h>
#include <softgrain/mpm/contact/contact_rows.h>

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace softgrain::mpm
{
/// A wall that a load moves along its normal or its tangent, as one unknown of a step: its velocity at the
/// end is free_speed - (the impulses it gives) / mass.
template <int dim>
struct FreeWall
{
  unsigned int wall = 0;         ///< index among all walls
  dealii::Tensor<1, dim> normal; ///< of the wall, unit
  dealii::Tensor<1, dim> way;    ///< unit, along which it is free: the normal or the tangent
  double mass = 0;               ///< [kg/m in 2D]
  double start_speed = 0;        ///< that way at the start of the step [m/s]
  double free_speed = 0;         ///< at its end without contact [m/s]
  double length = 0;             ///< of the cell across it, of a side of one that repeats; else 0 [m]
  unsigned int slab = ContactRow<dim>::none; ///< body that it is made of; none: it is a plane or a side
  double stop = 0;                           ///< largest speed at the end, either way; 0: any [m/s]
  double speed = 0;                          ///< at the end under the impulses of the last solve [m/s]

  bool is_side() const { return length > 0.; } ///< of a cell
  /// Whether it is free along the tangent.
  bool slides() const { return std::abs(way * normal) < 0.5; }

  /// Gives a light wall that nothing bears a stop: @p most [m/s], or twice as fast as it is already.
  void stop_flight(const double most)
  {
    if (std::abs(free_speed) > most)
      stop = std::max(most, 2. * std::abs(start_speed));
  }
  /// Whether its speed is nearly that at which it is stopped.
  bool at_stop() const { return stop > 0. && std::abs(speed) > 0.9 * stop; }
  /// Largest speed that it may come to have, either way [m/s].
  double fastest() const { return stop > 0. ? stop : std::max(std::abs(start_speed), std::abs(free_speed)); }
  /// Speed at the end of a step of @p dt over which it goes @p gone [m/s].
  double speed_after(const double gone, const double theta, const double dt) const
  {
    return (gone / dt - (1. - theta) * start_speed) / theta;
  }
};

/**
 * @brief The free walls of a step and what they add to its contact problem.
 *
 * A wall couples all its rows: its part of W is the outer product of a vector with itself. One with a stop
 * has two rows more, which follow those of the contacts: a rigid partner that stands where the wall must not
 * go any further, ahead and behind. So the solver finds by itself whether a wall is held by bodies or by its
 * stop.
 */
template <int dim>
class FreeWalls
{
public:
  std::vector<FreeWall<dim>> list;

  /// Takes the rows of the contacts.
  void reinit(const std::vector<ContactRow<dim>> &rows, unsigned int n_components);

  /// Rows of the stops, after those of the contacts.
  unsigned int n_stops() const { return stops; }
  /// The free wall that the stop row @p s belongs to.
  unsigned int wall_of_stop(const unsigned int s) const { return stop_wall[s]; }

  /// A wall's share in the velocity of a component: +1 where it moves towards the bodies of a row.
  struct Entry
  {
    unsigned int component;
    double factor;
  };
  const std::vector<Entry> &entries(const unsigned int k) const { return of_wall[k]; }

  void add_blocks(contact::BlockDelassus &W) const;

  /// Velocities of the stops without impulses, appended [m/s].
  void add_stops(std::vector<double> &free_velocity) const;

  /**
   * @brief Part of the speed of approach that the loads leave when no wall goes beyond its stop.
   *
   * A load that nothing bears drives a light wall away at hundreds of times the speed it can have in the
   * step, and errors are relative to the speed of approach: tolerances are to be multiplied by this.
   */
  double tolerance_factor(const std::vector<double> &free_velocity) const;

  /// Sets the speeds at the end for these impulses [N s/m].
  void move(const std::vector<double> &impulse);

private:
  unsigned int n_components = 1, n_rows = 0, stops = 0;
  std::vector<std::vector<Entry>> of_wall;
  std::vector<unsigned int> stop_wall;
};
} // namespace softgrain::mpm

#endif
