// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of BpmModel that makes attraction differ within bodies and between them.
#include <softgrain/base/exceptions.h>
#include <softgrain/base/random.h>
#include <softgrain/bpm/bpm_model.h>
#include <softgrain/geometry/shape.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <sstream>

namespace softgrain::bpm
{
void BpmModel::grade(Primaries &disks) const
{
  const PrimarySettings &given = settings.primaries;
  if (given.strength == "1" && given.strength_spread == 0.)
    return;
  const Expression strength(given.strength, {"x", "y", "r"});
  Uniform uniform(given.seed + 0x5eed);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
  {
    const BodyDescription<2> &body = scene.bodies[b];
    const double radius = std::sqrt(body.shape->area() / dealii::numbers::PI),
                 of_body = 1. + given.strength_spread * (2. * uniform() - 1.);
    for (std::size_t i = first_of_body[b]; i < first_of_body[b + 1]; ++i)
    {
      const double x = (disks.position[i][0] - body.center[0]) / radius,
                   y = (disks.position[i][1] - body.center[1]) / radius,
                   value = strength({x, y, std::hypot(x, y)});
      if (!(value >= 0.) || !std::isfinite(value))
      {
        std::ostringstream message;
        message << "'Primaries/Strength' = '" << given.strength << "' is " << value << " at x = " << x
                << ", y = " << y << " of body '" << body.name << "': it must be 0 or more";
        throw InputError(message.str());
      }
      disks.strength.push_back(of_body * value);
    }
  }
}
} // namespace softgrain::bpm
