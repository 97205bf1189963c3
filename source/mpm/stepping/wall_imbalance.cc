// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/wall_imbalance.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace softgrain::mpm
{
void WallImbalance::compare(const std::size_t of_wall,
                            const bool along_tangent,
                            const double borne,
                            const double asked,
                            const double floor)
{
  const double lacking = std::abs(borne - asked) / std::max(std::abs(asked), floor);
  if (lacking > share)
    *this = {lacking, of_wall, along_tangent, borne, asked};
}

std::string WallImbalance::in_words(const std::string &name, const std::string &unit) const
{
  const std::string what = std::string(slides ? "shear stress" : "pressure") + " of wall '" + name + "'";
  if (force == 0.)
    return "nothing bears the " + what;
  return short_number(force) + " " + unit + " act against the " + what + ", which is " + short_number(load) +
         " " + unit;
}

template <int dim>
double softest(const std::vector<Body<dim>> &bodies)
{
  double modulus = std::numeric_limits<double>::max();
  for (const Body<dim> &body : bodies)
    if (!body.rigid.driven)
      modulus = std::min(modulus, body.material.law->young_modulus());
  return modulus;
}

template double softest(const std::vector<Body<2>> &);
template double softest(const std::vector<Body<3>> &);
} // namespace softgrain::mpm
