// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_surface_contact_h
#define softgrain_mpm_contact_surface_contact_h

#include <softgrain/mpm/contact/contact_geometry.h>

namespace softgrain::mpm
{
/**
 * @brief Rows between boundaries: a marker of one body against a plane wall or against the polyline of
 * another body.
 *
 * Gap and normal come from the polylines, not from the grid, so bodies touch where they are, not a cell
 * early. Markers that look for contact are 'Contact/Marker spacing' apart, half a cell by default. The field
 * cannot tell many more rows apart, and W would become singular. Between two bodies the markers of one meet
 * the segments of the other; which is which depends on the indices of the bodies alone.
 */
class SurfaceContact final : public ContactGeometry<2>
{
public:
  void find(const ContactScene<2> &scene, std::vector<ContactRow<2>> &rows) const override;
  bool looks_by_body() const override { return true; }
};
} // namespace softgrain::mpm

#endif
