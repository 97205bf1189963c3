// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/contact_geometry_kind.h>
#include <softgrain/mpm/contact/nodal_contact.h>
#include <softgrain/mpm/model/settings.h>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::mpm::ContactGeometryKind)

namespace softgrain::mpm
{
namespace
{
class ByRays final : public ContactGeometryKind
{
public:
  bool by_rays() const override { return true; }
  std::unique_ptr<ContactGeometry<2>> create(const ShapeFunction &, const Settings &) const override
  {
    return nullptr;
  }
};

class AtNodes final : public ContactGeometryKind
{
public:
  bool at_nodes() const override { return true; }
  std::unique_ptr<ContactGeometry<2>> create(const ShapeFunction &shape,
                                             const Settings &settings) const override
  {
    return std::make_unique<NodalContact>(shape, settings.nodal_gap);
  }
};

[[maybe_unused]] const bool registered[] = {
    Registry<ContactGeometryKind>::instance().add(
        "rays",
        "rays that stand in space during a step meet the surfaces, and Newton's method knows how",
        [] { return std::make_unique<ByRays>(); }),
    Registry<ContactGeometryKind>::instance().add(
        "nodes",
        "contact at grid nodes that bodies share (the thesis; needs 'Grid update = every step')",
        [] { return std::make_unique<AtNodes>(); })};
} // namespace
} // namespace softgrain::mpm
