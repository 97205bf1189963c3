// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_state_h
#define softgrain_mpm_model_state_h

#include <softgrain/base/parallel.h>
#include <softgrain/driving/adhesion.h>
#include <softgrain/driving/balance.h>
#include <softgrain/driving/cell_motion.h>
#include <softgrain/driving/obstacle.h>
#include <softgrain/driving/wall.h>
#include <softgrain/driving/works.h>
#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/contact/contact_frame.h>
#include <softgrain/mpm/contact/contact_memory.h>
#include <softgrain/mpm/contact/contact_rows.h>

#include <deal.II/base/tensor.h>

#include <memory>
#include <optional>
#include <vector>

namespace softgrain::mpm
{
template <int dim>
class PointStore;

/// What the balances of MPM are made of beside those of every model, since the start; per metre of thickness.
struct Balance : softgrain::Balance
{
  double subgrid_energy = 0; ///< in the dents that the grid misses, now [J/m]
};

/// Names of its losses, which are columns NAME_J_per_m of the history but for that of laws.
namespace loss
{
constexpr const char *law = "law_loss",          ///< in points
    *scheme = "scheme_damping",                  ///< by theta > 1/2
        *regularisation = "regularisation_work", ///< by the regularising forces of `quasi_static`
            *released = "released_energy";       ///< in held steps, beside what is booked
} // namespace loss

/**
 * @brief Where a computation has come to: what the next step starts from, and what checkpoints keep.
 *
 * begin_step() puts on walls and obstacles what is asked of them; all else that a step changes is written by
 * accept_step().
 */
struct State
{
  State();
  ~State();

  std::unique_ptr<PointStore<2>> points; ///< of all bodies
  std::vector<Body<2>> bodies;
  std::vector<Wall<2>> walls;
  std::vector<Obstacle<2>> obstacles;
  ContactMemory<2> memory;             ///< impulses of the last step
  std::vector<ContactFrame<2>> frames; ///< of the last step, where contact is found by rays
  /// `quasi_static`: what resisted the motion of each body at the end of the last step [N/m].
  std::vector<dealii::Tensor<1, 2>> resistance;
  /// What holds back each body where rays find contact, summed over nodes without regard to direction: none
  /// where a body is not held back, whatever holds it against turning or changing its shape [N/m].
  std::vector<double> held_back;
  Adhesion adhesion;
  Balance balance;
  double time = 0; ///< [s]

  /// Done on the bodies since the start, by walls, loads and all else [J/m].
  double external_work() const { return softgrain::external_work(balance, walls, obstacles); }

  /// Finds the order of the bodies' points after some were added or sorted.
  void order_points();

  /// Whether it is a cell that repeats.
  bool repeats() const;

  /// How the cell deforms in a step; nothing when it does not repeat.
  std::optional<CellMotion<2>> cell_motion(const std::vector<WallMotion<2>> &motion) const;
};

/// Calls @p work for every one of @p bodies that is not driven, on all threads; it may write only to what is
/// its body's.
template <class Bodies, class Work>
void for_moving(Bodies &bodies, const Work &work)
{
  parallel_for(bodies.size(), 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t b = begin; b < end; ++b)
                   if (!bodies[b].rigid.driven)
                     work(bodies[b]);
               });
}
} // namespace softgrain::mpm

#endif
