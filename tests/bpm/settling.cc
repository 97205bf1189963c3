// SPDX-License-Identifier: LGPL-2.1-or-later
// Frictionless disks that attraction has brought to rest touch at 2N - 3 places: as many forces as there are
// directions to move in. A step from rest hardly moves them, beside what it would without contacts, and
// contact has nothing to push out, which would give energy.
#include "bpm_scene.h"

#include <softgrain/bpm/aggregate.h>
#include <softgrain/bpm/power_law.h>
#include <softgrain/geometry/shapes_2d.h>

#include <deal.II/base/parameter_handler.h>

#include <iostream>

using namespace softgrain;

namespace
{
std::shared_ptr<const bpm::Attraction> attraction()
{
  auto law = Registry<bpm::Attraction>::instance().create("power_law");
  dealii::ParameterHandler prm;
  law->declare_parameters(prm);
  prm.set("Force at contact", "1");
  law->parse_parameters(prm);
  return std::shared_ptr<const bpm::Attraction>(std::move(law));
}

bpm::Primaries at_rest(const bpm::Aggregate<2> &aggregate)
{
  bpm::Primaries disks;
  disks.position = aggregate.position;
  disks.radius = aggregate.radius;
  for (const double r : aggregate.radius)
    disks.mass.push_back(dealii::numbers::PI * r * r);
  disks.velocity.resize(aggregate.size());
  disks.body.resize(aggregate.size());
  return disks;
}

/// Sum of squares of the momenta of primaries after a step of @p dt from rest, with or without contacts.
double moved(const bpm::Aggregate<2> &aggregate, const double dt, const bool touching)
{
  bpm::DynamicsSettings settings;
  settings.solver.tolerance = 1e-8;
  settings.gap_correction = 0.;
  if (!touching)
    settings.contact_range = -1.;
  bpm::Dynamics dynamics(at_rest(aggregate), {attraction()}, {}, settings);
  std::vector<Wall<2>> none;
  dynamics.detect(none);
  dynamics.step(dt, none, {});
  double sum = 0.;
  for (std::size_t i = 0; i < aggregate.size(); ++i)
    for (const double v : dynamics.disks().velocity[i])
      sum += dynamics.disks().mass[i] * dynamics.disks().mass[i] * v * v;
  return sum;
}

/// By how much some exact steps from rest raise the energy of attraction, over that energy.
double given(const bpm::Aggregate<2> &aggregate, const double dt)
{
  bpm::DynamicsSettings settings;
  settings.solver.tolerance = 1e-10;
  settings.solver_penetration = 1e-12;
  bpm::Dynamics dynamics(at_rest(aggregate), {attraction()}, {}, settings);
  std::vector<Wall<2>> none;
  dynamics.detect(none);
  const double start = dynamics.sums().attraction;
  double highest = start;
  for (unsigned int step = 0; step < 4; ++step)
  {
    dynamics.step(dt, none, {});
    highest = std::max(highest, dynamics.sums().attraction);
  }
  return (highest - start) / -start;
}

std::size_t n_touching(const bpm::Aggregate<2> &aggregate, const double gap)
{
  std::size_t n = 0;
  for (std::size_t a = 0; a < aggregate.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      n += std::hypot(aggregate.position[a][0] - aggregate.position[b][0],
                      aggregate.position[a][1] - aggregate.position[b][1]) <
           aggregate.radius[a] + aggregate.radius[b] + gap;
  return n;
}

/// Three bodies of a shape: contacts over 2N - 3, and how strongly primaries still move.
void look(const std::string &what, std::shared_ptr<const Shape<2>> shape, const unsigned int number)
{
  BodyDescription<2> body;
  body.name = what;
  body.shape = std::move(shape);
  bpm::Settings settings;
  settings.primaries.sizes.smallest = 1.6;
  settings.primaries.sizes.largest = 2.6;
  settings.primaries.number = number;
  double contacts = 0., degrees = 0., left = 0., free = 0., gift = 0.;
  for (unsigned int seed = 1; seed <= 3; ++seed)
  {
    const bpm::Aggregate<2> aggregate = bpm::make_aggregate(body, 1., attraction(), settings, seed);
    contacts += n_touching(aggregate, 2e-4);
    degrees += 2. * aggregate.size() - 3.;
    const double dt = 0.2 * bpm::attraction_time<2>(2.1, 1., 1.);
    left += moved(aggregate, dt, true);
    free += moved(aggregate, dt, false);
    gift = std::max(gift, given(aggregate, dt));
  }
  std::cout << what << ": " << contacts / degrees
            << " of the contacts of an aggregate at rest, left of the forces "
            << below(5e-3, std::sqrt(left / free)) << ", energy from nothing " << below(1e-8, gift) << '\n';
}
} // namespace

int main()
{
  look("disk", std::make_shared<Disk2D>(Shape<2>::Place(), 15.), 0);
  look("small disk of a given number", std::make_shared<Disk2D>(Shape<2>::Place(), 8.), 30);
  look("long bar", std::make_shared<Rectangle2D>(Shape<2>::Place(), dealii::Tensor<1, 2>({60., 12.})), 0);
}
