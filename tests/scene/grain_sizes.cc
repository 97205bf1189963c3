// SPDX-License-Identifier: LGPL-2.1-or-later
// Distributions of sizes have the mean and the spread that they are given, classes the shares; 0.84 is
// reached without overlap.
#include <softgrain/base/exceptions.h>
#include <softgrain/packing/packing.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace softgrain;

namespace
{
/// Mean and standard deviation of a distribution, over equal shares.
void moments(const char *name, const SizeDistribution &sizes)
{
  constexpr unsigned int n = 20000;
  double mean = 0., square = 0., area = 0.;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double d = sizes.quantile((i + 0.5) / n);
    mean += d / n;
    square += d * d / n;
    area += 0.25 * std::acos(-1.) * d * d / n;
  }
  std::cout << name << " mean " << mean << " deviation " << std::sqrt(square - mean * mean) << " area off by "
            << (std::abs(area / sizes.mean_area() - 1.) < 1e-3 ? 0 : 1) << '\n';
}

/// Largest difference of the quantiles of two distributions.
void alike(const char *name, const SizeDistribution &one, const SizeDistribution &other)
{
  double most = 0.;
  for (double u = 0.; u <= 1.; u += 0.05)
    most = std::max(most, std::abs(one.quantile(u) - other.quantile(u)));
  std::cout << name << " differ by " << (most < 1e-9 ? 0. : most) << '\n';
}

void shares(const char *name, const PackingRequest2D &request)
{
  std::cout << name;
  for (const unsigned int n : request.numbers())
    std::cout << ' ' << n;
  std::cout << '\n';
}

void dense(const char *name, PackingRequest2D request)
{
  const Packing<2> packing = make_packing(request);
  const double box = (request.upper[0] - request.lower[0]) * (request.upper[1] - request.lower[1]);
  const dealii::Tensor<1, 2> edges = request.upper - request.lower;
  double gap = 1.;
  for (std::size_t i = 0; i < packing.balls.size(); ++i)
  {
    const auto &a = packing.balls[i];
    for (unsigned int d = 0; d < 2 && !request.protocol.periodic[d]; ++d)
      gap = std::min(
          {gap, a.center[d] - request.lower[d] - a.radius, request.upper[d] - a.center[d] - a.radius});
    for (std::size_t j = 0; j < i; ++j)
    {
      dealii::Tensor<1, 2> apart = a.center - packing.balls[j].center;
      for (unsigned int d = 0; d < 2; ++d)
        if (request.protocol.periodic[d])
          apart[d] -= edges[d] * std::round(apart[d] / edges[d]);
      gap = std::min(gap, apart.norm() - a.radius - packing.balls[j].radius);
    }
  }
  std::cout << name << " fills " << solid_area(packing) / box << " overlaps " << (gap < 0.) << '\n';
}
} // namespace

int main()
{
  using Form = SizeDistribution::Form;
  SizeDistribution sizes;
  sizes.smallest = 1.;
  sizes.largest = 9.;
  sizes.mean = 3.;
  sizes.deviation = 0.3;
  sizes.form = Form::gaussian;
  moments("gaussian", sizes);
  sizes.form = Form::log_normal;
  moments("log-normal", sizes);
  SizeDistribution other = sizes;
  sizes.form = Form::power_law;
  for (const auto &[name, exponent, form] :
       {std::tuple("power 0 and uniform diameter", 0., Form::uniform_diameter),
        {"power 1 and uniform area", 1., Form::uniform_area},
        {"power -2 and equal areas", -2., Form::equal_areas}})
  {
    sizes.exponent = exponent;
    other.form = form;
    alike(name, sizes, other);
  }
  // Of d^-1 half of all disks are below the geometric mean.
  sizes.exponent = -1.;
  std::cout << "median of power -1: " << sizes.quantile(0.5) << '\n';

  PackingRequest2D request;
  request.number = 100;
  request.classes = parse_classes("0.5: 1; 0.5: 1.4");
  shares("two sizes, half of the number each:", request);
  request.shares_of_area = true;
  shares("half of the area each:", request); // 1.96 : 1
  request.shares_of_area = false;
  request.classes = parse_classes("1: 1 to 2, gel; 1: 2, stone, polygon; 1: 3, gel");
  shares("thirds of 100:", request);
  request.number = 2;
  try
  {
    request.numbers();
  }
  catch (const InputError &error)
  {
    std::cout << error.what() << '\n';
  }

  request = {};
  request.number = 60;
  request.sizes.smallest = 1.;
  request.sizes.largest = 2.;
  request.upper = {10., 10.};
  request.fraction = 0.82;
  dense("with walls", request);
  request.classes = parse_classes("0.5: 1; 0.5: 1.4");
  request.fraction = 0.82;
  request.protocol.periodic = {{true, true}};
  dense("two sizes, without walls", request);
  request.number = 16;
  request.protocol.friction = 0.5;
  try
  {
    make_packing(request);
  }
  catch (const InputError &error)
  {
    const std::string text = error.what();
    std::cout << "with friction: " << text.substr(0, text.find(": 16")) << ", "
              << (text.find(" is the most that was reached") != std::string::npos) << '\n';
  }
}
