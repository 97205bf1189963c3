// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of Dynamics that keeps the books of bodies that go their way whatever they meet.
#include <softgrain/bpm/dynamics.h>

namespace softgrain::bpm
{
void Dynamics::account_driven(const double dt, DynamicsReport &report) const
{
  if (std::none_of(fixed.begin(), fixed.end(), [](const bool one) { return one; }))
    return;
  // What drives them makes up for all that acts on them: contacts and attraction. Body forces it takes as it
  // gives.
  const std::size_t n = primaries.size();
  const auto is_fixed = [&](const std::uint32_t i) { return i < n && inverse_mass[i] == 0.; };
  std::vector<ExactSum> sums(4); // work on contacts, work on attraction, impulse on others
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    const std::uint32_t a = rows.a[row], b = rows.b[row];
    if (!is_fixed(a) && !is_fixed(b))
      continue;
    // They are each other's, and no more than one of the two is driven.
    const std::uint32_t own = is_fixed(a) ? a : b;
    const double sign = own == a ? 1. : -1.;
    const std::array<double, 2> &normal = rows.normal[row];
    std::array<double, 2> given = {rows.impulse[row] * normal[0], rows.impulse[row] * normal[1]}; // on a
    double turned = 0.;                                                                           // on own
    if (rotations)
    {
      const double slip = rows.tangential_impulse[row];
      given[0] -= slip * normal[1];
      given[1] += slip * normal[0];
      turned = -slip * (own == a ? rows.arm_a[row] : rows.arm_b[row]);
      if (!rows.rolling_impulse.empty())
        turned += sign * rows.rolling_impulse[row];
    }
    double work = 0.;
    for (unsigned int d = 0; d < 2; ++d)
    {
      work -= sign * given[d] * primaries.velocity[own][d];
      if (b < n)
        sums[2 + d].add(-sign * given[d]);
    }
    if (rotations)
      work -= turned * primaries.angular_velocity[own];
    sums[0].add(work);
  }
  for (std::size_t i = 0; i < n_own(); ++i)
    if (inverse_mass[i] == 0.)
      sums[1].add(-dt * (force[i][0] * primaries.velocity[i][0] + force[i][1] * primaries.velocity[i][1]));
  if (share)
    add_over_all(sums, share->exchange);
  report.contact_loss += sums[0].value();
  report.driven_work = sums[0].value() + sums[1].value();
  report.driven_impulse = dealii::Tensor<1, 2>({sums[2].value(), sums[3].value()});
}
} // namespace softgrain::bpm
