// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/hertz_dent.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
constexpr double narrowest_contact = .05; ///< [cells]
} // namespace

HertzDent::HertzDent(const double modulus, const double radius, const double cell_size, const double beta)
    : modulus(modulus), radius(radius), cell_size(cell_size), beta(beta)
{
  const double a = narrowest_contact * cell_size;
  smallest = 4. / 3. * modulus * a * a * a / radius;
  of_smallest = a * a / radius - beta * smallest / (modulus * cell_size);
}

double HertzDent::operator()(const double force) const
{
  if (modulus == 0. || force <= 0.)
    return 0.;
  if (force < smallest)
    return force / smallest * of_smallest;
  const double a = std::cbrt(0.75 * force * radius / modulus);
  return 0.75 * cell_size / a > beta ? a * a / radius - beta * force / (modulus * cell_size) : 0.;
}

double HertzDent::per_force(const double force) const
{
  if (modulus == 0.)
    return 0.;
  return force < smallest ? of_smallest / smallest : (*this)(force) / force;
}

double HertzDent::energy(const double force) const
{
  if (modulus == 0. || force <= 0.)
    return 0.;
  if (force < smallest)
    return 0.5 * of_smallest * force * force / smallest;
  // F dδ, of a²/R = F^(2/3) ... and of the part that the grid shows.
  const auto work = [this](const double f)
  {
    const double a = std::cbrt(0.75 * f * radius / modulus);
    return 0.4 * f * a * a / radius - 0.5 * beta * f * f / (modulus * cell_size);
  };
  const double widest = 0.75 * cell_size / beta,
               largest = 4. / 3. * modulus * widest * widest * widest / radius;
  return 0.5 * of_smallest * smallest + work(std::min(force, largest)) - work(smallest);
}

double HertzDent::slope(const double force) const
{
  if (modulus == 0.)
    return 0.;
  if (force < smallest)
    return of_smallest / smallest;
  const double a = std::cbrt(0.75 * force * radius / modulus);
  return 0.75 * cell_size / a > beta ? 0.5 / (modulus * a) - beta / (modulus * cell_size) : 0.;
}
} // namespace softgrain::mpm
