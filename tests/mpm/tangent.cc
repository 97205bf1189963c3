// SPDX-License-Identifier: LGPL-2.1-or-later
// The stiffness is the derivative of the internal force, and the internal force that of the stored energy:
// for every shape function, law and F-bar, on a disk whose boundary cells are extended, far from rest and
// with deformation carried from an earlier grid.
#include "cut_disk.h"

#include <softgrain/mpm/stepping/stress.h>

#include <iostream>
#include <random>

using namespace softgrain;

namespace
{
const std::string scene = cut_disk(R"(subsection Materials
  set Names = m
  subsection m
    subsection Linear elastic
      set Young's modulus = 3
      set Poisson's ratio = 0.3
    end
    subsection Neo-Hookean
      set Young's modulus = 3
      set Poisson's ratio = 0.3
    end
    subsection Hencky
      set Young's modulus = 3
      set Poisson's ratio = 0.3
    end
  end
end
)");

struct Evaluation
{
  double energy;
  Eigen::VectorXd force;
  mpm::StepState<2> points;
};

Evaluation evaluate(const mpm::Body<2> &body, const Eigen::VectorXd &u)
{
  Evaluation e;
  if (!mpm::evaluate_stress(body, u, u, {0., true, 0.}, e.points).good())
    std::cout << "inside out\n";
  e.energy = mpm::measure_points(body, u, u).energy;
  mpm::internal_force(body, e.points, e.force);
  return e;
}

void check(const std::string &shape, const std::string &law, const std::string &f_bar)
{
  const auto model = scene_of_text(scene, {"Material points/Shape function=" + shape,
                                           "Materials/m/Law=" + law, "Material points/F-bar=" + f_bar});
  mpm::Body<2> body = model->bodies()[0];
  std::mt19937 generator(7);
  std::uniform_real_distribution<> uniform(-1., 1.);
  const auto random = [&](const double size)
  {
    Eigen::VectorXd v(body.field.n_dofs());
    for (double &x : v)
      x = size * uniform(generator);
    return v;
  };
  for (unsigned int p = 0; p < body.points.size(); ++p)
    for (unsigned int d = 0; d < 2; ++d)
      for (unsigned int e = 0; e < 2; ++e)
        body.points[p].gradient()[d][e] += 0.1 * uniform(generator);
  const Eigen::VectorXd u = random(0.08), d = random(1.);
  constexpr double step = 1e-5;
  const Evaluation at = evaluate(body, u);
  const Eigen::VectorXd Kd = stiffness_times(body, at.points, d);
  const Evaluation plus = evaluate(body, Eigen::VectorXd(u + step * d));
  const Evaluation minus = evaluate(body, Eigen::VectorXd(u - step * d));
  const Eigen::VectorXd slope = (minus.force - plus.force) / (2. * step);
  const double work = (minus.energy - plus.energy) / (2. * step);
  std::cout << shape << ' ' << law << " F-bar " << f_bar << ": stiffness "
            << below(1e-8, (Kd - slope).norm() / slope.norm()) << ", force "
            << below(1e-6, (work - at.force.dot(d)) / work) << '\n';
}
} // namespace

int main()
{
  for (const std::string shape : {"linear", "gimp", "bspline"})
    for (const std::string law : {"linear_elastic", "neo_hookean", "hencky"})
      for (const std::string f_bar : {"off", "on"})
        check(shape, law, f_bar);
}
