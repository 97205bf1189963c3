// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/hertz_dent.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
constexpr double narrowest_contact = .05;          ///< [cells]
constexpr double wide_share = .127, seen_at = 1.8; ///< seen whole from there on [cells]
} // namespace

HertzDent::HertzDent(const double modulus, const double radius, const double cell_size, const double beta)
    : modulus(modulus), radius(radius), cell_size(cell_size), beta(beta), ends_at(seen_at * cell_size)
{
  const double a = narrowest_contact * cell_size;
  smallest = force_of(a);
  of_smallest = a * a / radius - beta * smallest / (modulus * cell_size);
  // Newton's method for 3/4x - beta = wide_share (1 - x / seen_at)^2 comes from the left: the difference is
  // convex.
  double x = 0.75 / (beta + wide_share);
  for (unsigned int iteration = 0; iteration < 6; ++iteration)
  {
    const double left = 1. - x / seen_at;
    x += (0.75 / x - beta - wide_share * left * left) / (0.75 / (x * x) - 2. * wide_share * left / seen_at);
  }
  wide_from = x * cell_size;
}

double HertzDent::force_of(const double a) const
{
  return 4. / 3. * modulus * a * a * a / radius;
}

double HertzDent::radius_of_contact(const double force) const
{
  return std::cbrt(0.75 * force * radius / modulus);
}

double HertzDent::operator()(const double force) const
{
  if (modulus == 0. || force <= 0.)
    return 0.;
  if (force < smallest)
    return force / smallest * of_smallest;
  const double a = radius_of_contact(force);
  if (a < wide_from)
    return a * a / radius - beta * force / (modulus * cell_size);
  const double left = std::max(0., 1. - a / ends_at);
  return wide_share * left * left * force / (modulus * cell_size);
}

double HertzDent::per_force(const double force) const
{
  if (modulus == 0.)
    return 0.;
  return force < smallest ? of_smallest / smallest : (*this)(force) / force;
}

double HertzDent::narrow_work(const double force) const
{
  const double a = radius_of_contact(force);
  return 0.4 * force * a * a / radius - 0.5 * beta * force * force / (modulus * cell_size);
}

double HertzDent::wide_work(const double force) const
{
  const double y = radius_of_contact(force) / ends_at;
  return wide_share * force * force / (modulus * cell_size) * (0.5 - 8. / 7. * y + 0.625 * y * y);
}

double HertzDent::energy(const double force) const
{
  if (modulus == 0. || force <= 0.)
    return 0.;
  if (force < smallest)
    return 0.5 * of_smallest * force * force / smallest;
  const double widening = force_of(wide_from), last = force_of(ends_at);
  const double narrow =
      0.5 * of_smallest * smallest + narrow_work(std::min(force, widening)) - narrow_work(smallest);
  return force < widening ? narrow : narrow + wide_work(std::min(force, last)) - wide_work(widening);
}

double HertzDent::slope(const double force) const
{
  if (modulus == 0.)
    return 0.;
  if (force < smallest)
    return of_smallest / smallest;
  const double a = radius_of_contact(force);
  if (a < wide_from)
    return 0.5 / (modulus * a) - beta / (modulus * cell_size);
  const double y = std::min(1., a / ends_at);
  return wide_share / (modulus * cell_size) * (1. - y) * (1. - 5. / 3. * y);
}
} // namespace softgrain::mpm
