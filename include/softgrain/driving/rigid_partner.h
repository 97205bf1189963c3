// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_rigid_partner_h
#define softgrain_driving_rigid_partner_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace softgrain
{
/// Work of something driven, and by how much it differs from that of the force at either end [J/m^(3-dim)].
struct DrivenWork
{
  double *work;
  double most;
};

/// What a rigid partner gives to a body at one place in a step.
template <int dim>
struct PartnerImpulse
{
  dealii::Tensor<1, dim> direction; ///< unit; or all that is given, where `impulse` is 1
  double impulse = 0.;              ///< along it; of the forces at the end of the step [N s/m^(3-dim)]
  double acting = 0.;               ///< the same, with which it does work
  dealii::Point<dim> place;         ///< [m]
  dealii::Tensor<1, dim>
      velocity;       ///< of the place, of a partner whose places have velocities of their own [m/s]
  double dt = 0.;     ///< [s]
  double moment = 0.; ///< beside it, of resistance to rolling [N s m/m^(3-dim)]

  dealii::Tensor<1, dim> given() const { return impulse * direction; }
};

/**
 * @brief Something that bodies meet and cannot deform: it feels what it gives to them, and keeps a book of
 * its work.
 *
 * One is made for the books of one step, when its way over that step is known. It begins with nothing felt.
 */
template <int dim>
class RigidPartner
{
public:
  virtual ~RigidPartner() = default;

  /// Feels what it has given to a body, and books the work of that if impulses are what does work.
  /// @return that work [J/m^(3-dim)]
  virtual double take(const PartnerImpulse<dim> &impulse) = 0;

  /// Ends a step from balance to balance, when all is felt: books the work of the mean of the forces at both
  /// ends, and adds to @p works by how much that may be wrong.
  virtual void book_mean(std::vector<DrivenWork> &works) = 0;

  /// Books the rest of the work of its load, after @p works of book_mean() have got their shares.
  /// @return the part of it that no body gets [J/m^(3-dim)]
  virtual double book_load() { return 0.; }

  /// Ends the step, when all is felt: a partner that impulses move goes on with another velocity. Walls under
  /// loads are unknowns of the step, and know theirs already.
  virtual void go_on() {}
};
} // namespace softgrain

#endif
