// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/measure.h>

#include <cmath>

namespace softgrain
{
namespace
{
/// Contact length over rest perimeter, both summed over the bodies @cite nguyen2016, eq. (4.6); a contact of
/// two bodies counts for both, one with a wall once.
class ContactSurface final : public Measure
{
public:
  std::vector<std::string> columns() const override { return {"specific_contact_surface"}; }

  std::vector<MeasuredValue> evaluate(const Assembly &assembly) const override
  {
    if (assembly.snapshot.bodies.empty())
      return {std::nullopt};
    double surface = 0., perimeter = 0.;
    for (const BodyContact &contact : assembly.contacts)
      surface += (contact.with_wall() ? 1. : 2.) * contact.length;
    for (unsigned int b = 0; b < assembly.snapshot.bodies.size(); ++b)
      perimeter += M_PI * assembly.rest_diameter(b);
    return {surface / perimeter};
  }
};

[[maybe_unused]] const bool registered = register_measure<ContactSurface>(
    "contact_surface", "specific contact surface S: contact length over rest perimeter");
} // namespace
} // namespace softgrain
