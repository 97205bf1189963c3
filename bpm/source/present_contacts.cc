// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/bpm/dynamics.h>
#include <softgrain/bpm/present_contacts.h>

#include <cmath>

namespace softgrain::bpm
{
const contact::DiskContacts &PresentContacts::rows() const
{
  return dynamics.rows;
}

const std::vector<double> &PresentContacts::gaps() const
{
  return dynamics.gap;
}

bool PresentContacts::carries_force(const std::size_t row) const
{
  return dynamics.carries_force(row);
}

PeriodicCell<2>::Image PresentContacts::image_of_row(const std::size_t row) const
{
  return dynamics.list.image(dynamics.pair_of_row[row]);
}

double PresentContacts::penetration() const
{
  return dynamics.deepest;
}

const contact::NeighbourList &PresentContacts::neighbours() const
{
  return dynamics.list;
}

std::size_t PresentContacts::lists_made() const
{
  return dynamics.n_lists;
}

double PresentContacts::attraction_of(const std::size_t pair) const
{
  const Primaries &primaries = dynamics.primaries;
  const auto &laws = dynamics.laws;
  const std::uint32_t a = dynamics.list.a(pair), b = dynamics.list.b(pair);
  if (laws.empty() || primaries.body[a] != primaries.body[b] || !laws[primaries.body[a]])
    return 0.;
  const double distance = std::hypot(primaries.position[a][0] - primaries.position[b][0],
                                     primaries.position[a][1] - primaries.position[b][1]);
  return attraction_at(*laws[primaries.body[a]], distance, primaries.radius[a] + primaries.radius[b]) *
         dynamics.strength_of(a, b);
}
} // namespace softgrain::bpm
