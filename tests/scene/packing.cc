// SPDX-License-Identifier: LGPL-2.1-or-later
// Random packings: no overlaps, everything inside of the box, the same for the same seed, sizes as asked for;
// what cannot be packed is refused; files come back as they were written.
#include <softgrain/base/exceptions.h>
#include <softgrain/packing/packing.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <string>

using namespace softgrain;

namespace
{
void look(const unsigned int n,
          const double fraction,
          const double smallest,
          const SizeDistribution::Form form)
{
  PackingRequest2D request;
  request.number = n;
  request.sizes.smallest = smallest;
  request.sizes.largest = 2.;
  request.sizes.form = form;
  const double edge = std::sqrt(n * request.sizes.mean_area() / fraction);
  request.lower = dealii::Point<2>(-3., 5.);
  request.upper = request.lower + dealii::Point<2>(1.2 * edge, edge / 1.2);
  const Packing<2> packing = make_packing(request), again = make_packing(request);
  double overlap = 0., outside = 0.;
  bool same = true;
  for (std::size_t i = 0; i < packing.balls.size(); ++i)
  {
    const Packing<2>::Ball &disk = packing.balls[i];
    same = same && disk.center == again.balls[i].center && disk.radius == again.balls[i].radius;
    for (unsigned int d = 0; d < 2; ++d)
      outside = std::max({outside, request.lower[d] + disk.radius - disk.center[d],
                          disk.center[d] + disk.radius - request.upper[d]});
    for (std::size_t j = 0; j < i; ++j)
      overlap = std::max(overlap, disk.radius + packing.balls[j].radius -
                                      disk.center.distance(packing.balls[j].center));
  }
  const double ratio = solid_area(packing) / (n * request.sizes.mean_area());
  std::cout << packing.balls.size() << " disks at " << fraction << ": overlap " << overlap << ", outside "
            << outside << ", " << (same ? "repeatable" : "NOT REPEATABLE") << ", area "
            << (std::abs(ratio - 1.) < 3. / std::sqrt(1. * n) ? "as expected" : "WRONG") << '\n';
}

/// Overlap and contacts of a packing with sides or without, over which disks are near each other.
void look_across(const std::string &name, const PackingRequest2D &request, const double from, const double to)
{
  const Packing<2> packing = make_packing(request);
  const dealii::Tensor<1, 2> edges = request.upper - request.lower;
  double overlap = 0., mean = 0., outside = 0.;
  for (const Packing<2>::Ball &disk : packing.balls)
    mean += disk.radius / packing.balls.size();
  unsigned int touching = 0, across = 0;
  const auto &disks = packing.balls;
  for (std::size_t i = 0; i < disks.size(); ++i)
  {
    for (unsigned int d = 0; d < 2; ++d)
    {
      const double free = request.protocol.periodic[d] ? 0. : disks[i].radius;
      outside = std::max({outside, request.lower[d] + free - disks[i].center[d],
                          disks[i].center[d] + free - request.upper[d]});
      if (!request.protocol.periodic[d])
        for (const double gap :
             {disks[i].center[d] - free - request.lower[d], request.upper[d] - free - disks[i].center[d]})
          touching += gap < 0.02 * mean;
    }
    for (std::size_t j = 0; j < i; ++j)
    {
      dealii::Tensor<1, 2> apart = disks[i].center - disks[j].center;
      bool crosses = false;
      for (unsigned int d = 0; d < 2; ++d)
        if (request.protocol.periodic[d] && std::abs(apart[d]) > 0.5 * edges[d])
        {
          apart[d] -= std::copysign(edges[d], apart[d]);
          crosses = true;
        }
      const double gap = apart.norm() - disks[i].radius - disks[j].radius;
      overlap = std::max(overlap, -gap);
      touching += gap < 0.02 * mean ? 2 : 0;
      across += crosses && gap < 0.02 * mean;
    }
  }
  const double fraction = solid_area(packing) / (edges[0] * edges[1]);
  std::cout << name << ": overlap " << overlap << ", outside " << std::max(0., outside) << ", fraction "
            << (fraction >= from && fraction <= to ? "as expected" : "WRONG") << ", touching per disk "
            << (touching > 3. * disks.size() ? "above 3" : "below 3") << ", across the edge "
            << (across > 0 ? "some" : "none") << '\n';
  if (!(fraction >= from && fraction <= to))
    std::cout << fraction << '\n';
}

/// Two disks in a box in which the first one, in the middle, would leave no room for the second.
void two_in_a_small_box()
{
  PackingRequest2D request;
  request.number = 2;
  request.sizes.smallest = request.sizes.largest = 2.;
  request.lower = dealii::Point<2>(0., 0.);
  request.upper = dealii::Point<2>(5., 5.);
  request.fraction = 0.4;
  unsigned int made = 0;
  for (request.seed = 1; request.seed <= 200; ++request.seed)
  {
    const Packing<2> packing = make_packing(request);
    made += packing.balls[0].center.distance(packing.balls[1].center) >= 2.;
  }
  std::cout << "two disks in a small box: " << made << " of 200\n";
}

template <typename F>
void refused(const F &work)
{
  try
  {
    work();
    std::cout << "NOT REFUSED\n";
  }
  catch (const InputError &error)
  {
    std::cout << error.what() << '\n';
  }
}
} // namespace

int main()
{
  using Form = SizeDistribution::Form;
  look(300, 0.70, 1.2, Form::uniform_area);
  look(300, 0.80, 1.2, Form::equal_areas);
  look(40, 0.74, 1.0, Form::uniform_diameter);
  look(20, 0.30, 2.0, Form::uniform_area);
  look(40, 0.70, 2.0, Form::uniform_area);

  PackingRequest2D request;
  request.number = 150;
  request.sizes.smallest = 1.2;
  request.sizes.largest = 2.;
  request.lower = dealii::Point<2>(1., 2.);
  request.upper = dealii::Point<2>(21., 18.);
  request.fraction = 0.72;
  look_across("fraction 0.72", request, 0.7199, 0.7201);
  request.protocol.periodic = {{true, false}};
  look_across("fraction 0.72, periodic in x", request, 0.7199, 0.7201);
  request.fraction = 0.;
  request.protocol.jam = true;
  request.protocol.periodic = {{false, false}};
  look_across("jammed", request, 0.80, 0.85);
  request.protocol.periodic = {{true, true}};
  look_across("jammed, periodic", request, 0.82, 0.86);
  request.protocol.friction = 0.8;
  look_across("jammed, periodic, friction", request, 0.74, 0.83);
  two_in_a_small_box();
  refused(
      []
      {
        PackingRequest2D request;
        request.number = 100;
        request.sizes.smallest = request.sizes.largest = 2.;
        request.lower = dealii::Point<2>(0., 0.);
        request.upper = dealii::Point<2>(18., 18.);
        make_packing(request);
      });

  Packing<2> packing;
  packing.balls = {{dealii::Point<2>(0.1, -2e-7), 1. / 3.}, {dealii::Point<2>(1e10, 0.), 2.}};
  write_packing("packing.csv", packing);
  const Packing<2> back = read_packing<2>("packing.csv");
  bool same = back.balls.size() == 2;
  for (std::size_t i = 0; same && i < 2; ++i)
    same = back.balls[i].center == packing.balls[i].center && back.balls[i].radius == packing.balls[i].radius;
  std::cout << (same ? "read as written" : "NOT AS WRITTEN") << '\n';
  // From a spreadsheet of Windows: a byte-order mark, and lines that end with a carriage return.
  std::ofstream("windows.csv", std::ios::binary) << "\xEF\xBB\xBFx_m,y_m,radius_m\r\n1,2,0.5\r\n3,4,0.25\r\n";
  const Packing<2> windows = read_packing<2>("windows.csv");
  std::cout << "with marks of Windows: " << windows.balls.size() << " disks, the last at "
            << windows.balls.back().center << " of radius " << windows.balls.back().radius << '\n';
  packing.materials = {"soft rubber", "gel"};
  write_packing("materials.csv", packing);
  const Packing<2> mixed = read_packing<2>("materials.csv");
  std::cout << "with materials: " << mixed.balls.size() << " disks of " << mixed.materials[0] << " and "
            << mixed.materials[1] << '\n';
  refused([] { read_packing<2>("nothing.csv"); });
  std::ofstream("bad.csv") << "x_m,y_m,radius_m\n0,0,1\n0,1,-1\n";
  refused([] { read_packing<2>("bad.csv"); });
  std::ofstream("nameless.csv") << "x_m,y_m,radius_m,material\n0,0,1,gel\n0,3,1,\n";
  refused([] { read_packing<2>("nameless.csv"); });
  std::ofstream("too_many.csv") << "x_m,y_m,radius_m\n0,0,1,gel\n";
  refused([] { read_packing<2>("too_many.csv"); });
  std::ofstream("empty.csv") << "x_m,y_m,radius_m\n";
  refused([] { read_packing<2>("empty.csv"); });
}
