// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies and walls that do not see each other: everything falls freely.
#include <softgrain/mpm/contact/contact_geometry_kind.h>

using namespace softgrain;

class NoRows final : public mpm::ContactGeometry<2>
{
public:
  void find(const mpm::ContactScene<2> &, std::vector<mpm::ContactRow<2>> &rows) const override
  {
    rows.clear();
  }
};

class NoContact final : public mpm::ContactGeometryKind
{
public:
  std::unique_ptr<mpm::ContactGeometry<2>> create(const mpm::ShapeFunction &,
                                                  const mpm::Settings &) const override
  {
    return std::make_unique<NoRows>();
  }
};

[[maybe_unused]] const bool registered = Registry<mpm::ContactGeometryKind>::instance().add(
    "none", "nothing touches", [] { return std::make_unique<NoContact>(); });
