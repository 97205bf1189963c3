// SPDX-License-Identifier: LGPL-2.1-or-later
// Manufactured solution: generalised vortex. Error of the displacement of the points over cell sizes, every
// shape function.
#include "scene_of.h"

#include <deal.II/base/numbers.h>

#include <iostream>

using namespace softgrain;

namespace
{
/// Mean square error over the largest displacement, at the end time.
double error_of(const std::vector<std::string> &changes, const double end)
{
  const auto model = shipped_scene("verification/generalized_vortex.prm", changes);
  run_until(*model, end);
  const Snapshot<2> now = model->snapshot();
  const mpm::Body<2> &body = model->bodies()[0];
  double sum = 0., area = 0., largest = 0.;
  for (unsigned int p = 0; p < now.points.position.size(); ++p)
  {
    const dealii::Point<2> X = body.rest.position[p];
    const double R = X.norm(), s = R - 1.;
    const double angle =
        0.25 * (1. - std::cos(2. * dealii::numbers::PI * end)) * (1. - 32. * s * s + 256. * s * s * s * s);
    const dealii::Point<2> x(X[0] * std::cos(angle) - X[1] * std::sin(angle),
                             X[0] * std::sin(angle) + X[1] * std::cos(angle));
    sum += now.points.size[p] * (now.points.position[p] - x).norm_square();
    area += now.points.size[p];
    largest = std::max(largest, (x - X).norm());
  }
  return std::sqrt(sum / area) / largest;
}
} // namespace

/// With any argument one level finer, for the table in doc/results/verification.md.
int main(int argc, char **)
{
  std::vector<std::string> cells = {"0.1", "0.05"};
  if (argc > 1)
    cells.push_back("0.025");
  for (const std::string shape : {"linear", "bspline"})
  {
    double before = 0.;
    for (const std::string &cell : cells)
    {
      const double error = error_of(
          {"Material points/Shape function=" + shape, "Mesh/Cell size=" + cell, "Time/Time step=0.0125"},
          0.25);
      std::cout << shape << " h " << cell << ": error " << error;
      if (before > 0.)
        std::cout << ", order " << std::log2(before / error);
      std::cout << std::endl;
      before = error;
    }
  }
}
