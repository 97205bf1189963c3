// SPDX-License-Identifier: LGPL-2.1-or-later
// The stiffness is the derivative of the internal force for every law of finite strain, with F-bar and
// without: on a disk with extended cells on its rim, after a step from rest that makes those yield, creep and
// grow that can.
#include "cut_disk.h"

#include <softgrain/mpm/stepping/stress.h>

#include <iostream>
#include <random>

using namespace softgrain;

namespace
{
struct OfLaw
{
  std::string name, title;
  std::vector<std::string> constants;
  bool has_young = true; ///< and Poisson's ratio
};

const std::vector<OfLaw> laws = {
    {"neo_hookean", "Neo-Hookean", {}},
    {"hencky", "Hencky", {}},
    {"mooney_rivlin", "Mooney-Rivlin", {"Share of the second invariant=0.2"}},
    {"yeoh", "Yeoh", {"Second coefficient=-0.01", "Third coefficient=2e-4"}},
    {"gent", "Gent", {"Locking=3"}},
    {"ogden", "Ogden", {"Exponents=1.3, 5", "Weights=0.99, 0.01"}},
    {"j2_plastic", "J2 plastic", {"Yield stress=0.1", "Hardening modulus=0.3"}},
    {"viscoplastic",
     "Viscoplastic",
     {"Yield stress=0.1", "Drag stress=0.1", "Exponent=2", "Reference rate=1", "Hardening modulus=0"}},
    {"maxwell", "Maxwell", {"Shares=0.5, 0.3", "Relaxation times=1, 0.1"}},
    {"drucker_prager",
     "Drucker-Prager",
     {"Cohesion=0.05", "Friction=0.5", "Cap start=0.2", "Cap pressure=0.4"}},
    {"growth", "Growth", {"Rate=0.1"}},
    {"flory_rehner",
     "Flory-Rehner",
     {"Shear modulus=1", "Mixing pressure=1e3", "Chemical potential=-0.01*t"},
     false},
};

const std::string scene = cut_disk(R"(subsection Materials
  set Names = m
end
subsection Time
  set Scheme = quasi_static
end
)");

/// Force and, in @p points, what the stiffness is made of; the step of the law takes 0.5 s.
Eigen::VectorXd force(const mpm::Body<2> &body, const Eigen::VectorXd &u, mpm::StepState<2> &points)
{
  mpm::Trial trial;
  trial.tangent = true;
  trial.dt = 0.5;
  trial.time = 0.5;
  Eigen::VectorXd found;
  if (!mpm::evaluate_stress(body, u, u, trial, points).good())
    std::cout << "inside out\n";
  mpm::internal_force(body, points, found);
  return found;
}

void check(const std::string &shape, const OfLaw &law, const std::string &f_bar)
{
  const std::string material = "Materials/m/", section = material + law.title + "/";
  std::vector<std::string> changes = {"Material points/Shape function=" + shape,
                                      "Material points/F-bar=" + f_bar,
                                      "Material points/Points per direction=3", material + "Law=" + law.name};
  if (law.has_young)
    changes.insert(changes.end(), {section + "Young's modulus=3", section + "Poisson's ratio=0.3"});
  for (const std::string &constant : law.constants)
    changes.push_back(section + constant);
  const auto model = scene_of_text(scene, changes);
  const mpm::Body<2> &body = model->bodies()[0];
  std::mt19937 generator(7);
  std::uniform_real_distribution<> uniform(-1., 1.);
  Eigen::VectorXd u(body.field.n_dofs()), d(body.field.n_dofs());
  for (double &x : u)
    x = 0.05 * uniform(generator);
  for (double &x : d)
    x = uniform(generator);
  constexpr double step = 1e-6;
  mpm::StepState<2> at, apart;
  force(body, u, at);
  const Eigen::VectorXd Kd = stiffness_times(body, at, d);
  const Eigen::VectorXd plus = force(body, u + step * d, apart), minus = force(body, u - step * d, apart);
  const Eigen::VectorXd slope = (minus - plus) / (2. * step);
  double flowed = 0.;
  for (const double dissipated : at.dissipation)
    flowed += dissipated != 0.;
  std::cout << shape << ' ' << law.name << " F-bar " << f_bar << ": stiffness "
            << below(1e-6, (Kd - slope).norm() / slope.norm());
  if (body.material.law->n_history() > 0)
    std::cout << ", points that dissipate " << (flowed > 0.5 * body.points.size() ? "more" : "less")
              << " than half";
  std::cout << '\n';
}
} // namespace

int main()
{
  for (const std::string shape : {"bspline", "quadratic"})
    for (const OfLaw &law : laws)
      for (const std::string f_bar : {"off", "on"})
        check(shape, law, f_bar);
}
