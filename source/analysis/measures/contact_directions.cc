// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/measure.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
namespace
{
/// Probability density of the direction of the contacts between bodies @cite nguyen2016, eq. (2.29), in
/// sectors of ten degrees. It has the period pi and its integral over a full turn is one.
class ContactDirections final : public Measure
{
public:
  std::vector<std::string> columns() const override
  {
    std::vector<std::string> names;
    for (unsigned int s = 0; s < n_sectors; ++s)
      names.push_back("contact_density_at_" + std::to_string(10 * s + 5) + "_deg_per_rad");
    return names;
  }

  std::vector<MeasuredValue> evaluate(const Assembly &assembly) const override
  {
    std::vector<double> count(n_sectors, 0.);
    double n = 0.;
    for (const BodyContact &contact : assembly.contacts)
    {
      if (contact.with_wall())
        continue;
      double angle = std::atan2(contact.normal[1], contact.normal[0]);
      if (angle < 0.)
        angle += M_PI;
      // What lies on a border of sectors, as contacts of a lattice do, goes to the upper one whatever
      // rounding says.
      count[static_cast<unsigned int>(angle / M_PI * n_sectors + 1e-9) % n_sectors] += 1.;
      n += 1.;
    }
    std::vector<MeasuredValue> density(n_sectors);
    if (n > 0.)
      std::transform(count.begin(), count.end(), density.begin(),
                     [n](const double c) { return c / n * n_sectors / (2. * M_PI); });
    return density;
  }

private:
  static constexpr unsigned int n_sectors = 18;
};

[[maybe_unused]] const bool registered = register_measure<ContactDirections>(
    "contact_directions", "P(theta): how the contacts between bodies are spread over the directions");
} // namespace
} // namespace softgrain
