// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_contact_geometry_kind_h
#define softgrain_mpm_contact_contact_geometry_kind_h

#include <softgrain/base/registry.h>
#include <softgrain/mpm/contact/contact_geometry.h>
#include <softgrain/mpm/field/shape_function.h>

#include <memory>

namespace softgrain::mpm
{
struct Settings;

/**
 * @brief A way to look for contact: `Contact/Geometry` names a member of this family.
 */
class ContactGeometryKind
{
public:
  virtual ~ContactGeometryKind() = default;

  /// Whether rays meet the surfaces of the bodies (ContactFrame); else rows are found once in a step.
  virtual bool by_rays() const { return false; }

  /// Whether it needs a grid that lies under the present points ('Grid update = every step').
  virtual bool at_nodes() const { return false; }

  /// @param shape of the nodal fields, which outlives the geometry
  /// @return what finds the rows; null with rays, which have none
  virtual std::unique_ptr<ContactGeometry<2>> create(const ShapeFunction &shape,
                                                     const Settings &settings) const = 0;
};
} // namespace softgrain::mpm

template <>
softgrain::Registry<softgrain::mpm::ContactGeometryKind> &
softgrain::Registry<softgrain::mpm::ContactGeometryKind>::instance();

#endif
