// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_plane_partners_h
#define softgrain_mpm_stepping_plane_partners_h

#include <softgrain/driving/rigid_partner.h>
#include <softgrain/mpm/stepping/accept_step.h>

#include <memory>
#include <string>
#include <vector>

namespace softgrain::mpm
{
/// All that is rigid in a scene of the plane, for the books of a step: obstacles, walls and driven bodies.
class PlanePartners
{
public:
  PlanePartners(State &state, const Workspace &work, const FoundStep &step);

  /// What the body of a row meets; null: another body that can move.
  RigidPartner<2> *of(const ContactRow<2> &row) const;

  /// Books, from balance to balance, what they did beside the work of the forces at the end.
  void book_means(std::vector<DrivenWork> &works) const;
  /// Books the rest of the work of loads, see RigidPartner::book_load(). @return what of it is lost [J/m]
  double book_loads() const;
  /// Ends the step, see RigidPartner::go_on().
  void go_on() const;

private:
  using List = std::vector<std::unique_ptr<RigidPartner<2>>>;
  List numbered;      ///< by PartnerNumbers
  List driven_bodies; ///< by body; null: it can move
  std::size_t n_walls;
};

/// What a body meets, for messages, without the mark that ends its name: "wall 'top". @param number by
/// PartnerNumbers; none: it is @p body
std::string partner_in_words(const State &state, unsigned int number, unsigned int body);
} // namespace softgrain::mpm

#endif
