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

  /// Whether it looks at the boundaries of the bodies, so that rows can be found again while a step is being
  /// solved; else it needs a grid that lies under the present points ('Grid update = every step').
  virtual bool on_boundaries() const = 0;

  /// @param shape of the nodal fields, which outlives the geometry
  virtual std::unique_ptr<ContactGeometry<2>> create(const ShapeFunction &shape,
                                                     const Settings &settings) const = 0;
};
} // namespace softgrain::mpm

template <>
softgrain::Registry<softgrain::mpm::ContactGeometryKind> &
softgrain::Registry<softgrain::mpm::ContactGeometryKind>::instance();

#endif
