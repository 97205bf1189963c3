// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_nodal_contact_h
#define softgrain_mpm_contact_nodal_contact_h

#include <softgrain/mpm/contact/contact_geometry.h>
#include <softgrain/mpm/field/shape_function.h>

namespace softgrain::mpm
{
/**
 * @brief Multi-mesh contact, @cite nguyen2016, eqs. (3.23)-(3.26): rows at lattice nodes that bodies share.
 *
 * The normal comes from the mass gradients of both bodies; where three and more bodies meet, every pair has
 * its row. A body that lies all around a node has no gradient there: the normal is then that of the other
 * body alone. Plane walls count as bodies that fill the half space behind them.
 *
 * A node is shared as soon as both bodies come within the reach of its shape function, so bodies touch up to
 * two cells early. With the gap the row waits until the domains of the points that reach the node meet along
 * the normal.
 *
 * Bodies that approach by more than a cell within one step can pass each other unseen: keep 'Time/Time step'
 * below cell size over speed. The grid must lie under the present points ('Material points/Grid update' =
 * 'every step').
 */
class NodalContact final : public ContactGeometry<2>
{
public:
  /**
   * @param shape of the nodal fields; its reach says which nodes a plane wall shares
   * @param gap   whether a row waits until the domains of the points meet
   */
  NodalContact(const ShapeFunction &shape, bool gap);

  void find(const ContactScene<2> &scene, std::vector<ContactRow<2>> &rows) const override;

private:
  const double reach; ///< of a shape function, from its node [cells]
  const bool with_gap;
};
} // namespace softgrain::mpm

#endif
