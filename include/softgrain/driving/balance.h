// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_balance_h
#define softgrain_driving_balance_h

#include <softgrain/driving/named_sums.h>

#include <deal.II/base/tensor.h>

#include <string>

namespace softgrain
{
class StateReader;
class StateWriter;

/// What the momentum of all bodies is made of, per metre of thickness.
struct MomentumBalance
{
  dealii::Tensor<1, 2> initial, of_loads, of_walls; ///< at the start, and impulses since then [N s/m]
  double largest = 0;                               ///< scale of the error [N s/m]

  /// Sees to the scale: @p moving is the sum of the sizes of momenta, which may cancel in their sum [N s/m].
  void note(double moving);

  /**
   * @brief |@p now - (initial momentum + impulses of walls and loads)| over the largest momentum term.
   *
   * No number (NaN) while no term has been above @p rounding, what rounding alone makes of them [N s/m].
   */
  double error(const dealii::Tensor<1, 2> &now, double rounding = 0.) const;
};

/**
 * @brief Sums since the start that the balances of momentum and energy of every model are made of, per metre
 * of thickness.
 */
struct Balance
{
  MomentumBalance momentum;
  NamedSums load_work;     ///< done by loads, by their names [J/m]
  NamedSums losses;        ///< beside those below; columns NAME_J_per_m [J/m]
  NamedSums sums;          ///< what else columns of the history add up, by their names
  double driven_work = 0;  ///< done by driven bodies [J/m]
  double growth_work = 0;  ///< energy that active laws brought in [J/m]
  double cell_work = 0;    ///< of a cell that deforms, beside that of its sides: see CellMotion [J/m]
  double contact_loss = 0; ///< [J/m]
  double adhesion_work =
      0; ///< done by adhesion, which pulls what comes nearer; not part of contact_loss [J/m]
  double wall_damping_loss = 0; ///< in the damping of walls that are free to move [J/m]

  /// All that is lost [J/m].
  double dissipated() const { return contact_loss + losses.sum() + wall_damping_loss; }

  /// Done by all but walls and obstacles, which keep their own [J/m].
  double work_beside_walls() const
  {
    return load_work.sum() + driven_work + growth_work + cell_work + adhesion_work;
  }

  void save(StateWriter &out, const std::string &name) const;
  void load(const StateReader &in, const std::string &name);
};
} // namespace softgrain

#endif
