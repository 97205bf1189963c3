// SPDX-License-Identifier: LGPL-2.1-or-later
// Drucker-Prager with a cap: where pressure, tension, shear without change of volume and their mixtures end
// up, in closed form or on the surface; what is dissipated; the same bits with stresses twice as large, which
// is exact but for roots of a stress; and the properties of every law.
#include "law_point.h"
#include "law_properties.h"

#include <array>
#include <iomanip>

int main()
{
  using namespace softgrain;
  using namespace softgrain::test;
  std::cout << std::setprecision(9);
  const double E = 1e9, nu = 0.3, d = 2e6, m = 0.6, start = 5e6, end = 12e6;
  const double K = E / 3 / (1 - 2 * nu), mu = E / 2 / (1 + nu);
  const Settings settings = {{"Young's modulus", "1e9"}, {"Poisson's ratio", "0.3"},
                             {"Cohesion", "2e6"},        {"Friction", "0.6"},
                             {"Cap start", "5e6"},       {"Cap pressure", "12e6"}};
  const auto p = [](const LawPoint<3> &point) { return -dealii::trace(point.last.stress) / 3; };
  const auto q = [](const LawPoint<3> &point)
  { return std::sqrt(1.5) * dealii::deviator(point.last.stress).norm(); };
  const auto axes = [](const double x, const double y, const double z)
  {
    Tensor<2, 3> F;
    F[0][0] = std::exp(x);
    F[1][1] = std::exp(y);
    F[2][2] = std::exp(z);
    return F;
  };
  const auto follow = [&](const double x, const double y, const double z)
  {
    auto point = std::make_unique<LawPoint<3>>("drucker_prager", settings);
    for (unsigned int i = 1; i <= 200; ++i)
      point->go_to(axes(x * i / 200, y * i / 200, z * i / 200));
    std::cout << "  work is energy and what is dissipated, to 1 %: "
              << (std::abs((point->last.energy + point->dissipated) / point->work - 1) < 0.01 ? "yes" : "no")
              << ", dissipated: " << (point->dissipated > 0 ? "yes" : "no") << '\n';
    return point;
  };
  std::cout << "compressed from all sides\n";
  const auto compressed = follow(-0.02, -0.02, -0.02);
  std::cout << "  pressure / expected: " << p(*compressed) / end
            << ", plastic compaction / expected: " << compressed->history.end()[-2] / (0.06 - end / K)
            << '\n';
  // A cap that hardens is one step behind: with steps of half the length the error is half as large.
  const double H = 1e8, strain = 0.06, hard = (end + H * strain) / (1 + H / K);
  std::array<double, 2> error;
  for (const unsigned int steps : {200, 400})
  {
    Settings hardens = settings;
    hardens.push_back({"Cap hardening", "1e8"});
    LawPoint<3> point("drucker_prager", hardens);
    for (unsigned int i = 1; i <= steps; ++i)
      point.go_to(axes(-strain / 3 * i / steps, -strain / 3 * i / steps, -strain / 3 * i / steps));
    error[steps == 400] = 1 - p(point) / hard;
  }
  std::cout << "compressed, cap that hardens\n  short of the pressure expected by: " << error[0]
            << ", with half the step: " << error[1] << '\n';
  std::cout << "torn apart\n";
  const auto torn = follow(0.02, 0.02, 0.02);
  std::cout << "  pressure / expected: " << p(*torn) / (-d / m) << '\n';
  // q = q_trial - 3 mu D, p = K m D on the cone.
  std::cout << "sheared\n";
  const double e = 4e-3, q_trial = 2 * std::sqrt(3.) * mu * e, flow = (q_trial - d) / (3 * mu + K * m * m);
  const auto sheared = follow(e, -e, 0);
  std::cout << "  q / expected: " << q(*sheared) / (q_trial - 3 * mu * flow)
            << ", p / expected: " << p(*sheared) / (K * m * flow) << '\n';
  std::cout << "sheared on, to where cone and cap meet\n";
  const auto met = follow(0.1, -0.1, 0);
  std::cout << "  q / expected: " << q(*met) / (d + m * start) << ", p / expected: " << p(*met) / start
            << '\n';
  std::cout << "compressed along one axis\n";
  const auto mixed = follow(-0.02, 0, 0);
  const double u = (p(*mixed) - start) / (end - start), v = q(*mixed) / (d + m * start);
  std::cout << "  on the cap: " << u * u + v * v << ", off its ends: " << (u > 0.1 && v > 0.1 ? "yes" : "no")
            << '\n';
  Settings twice = settings;
  for (auto &[name, value] : twice)
    if (name != "Poisson's ratio" && name != "Friction")
      value = std::to_string(2 * std::stod(value));
  LawPoint<3> once("drucker_prager", settings), doubled("drucker_prager", twice);
  bool same = true;
  for (unsigned int i = 1; i <= 50; ++i)
  {
    once.go_to(axes(-4e-4 * i, 1e-5 * i, 0));
    doubled.go_to(axes(-4e-4 * i, 1e-5 * i, 0));
    same = same && (2. * once.last.stress - doubled.last.stress).norm() == 0.;
  }
  std::cout << "compressed with stresses twice as large: the same bits " << (same ? "yes" : "no") << '\n';
  bool holds = true;
  for (const char *friction : {"0", "0.6"})
    for (const char *cohesion : {"1e7", "2e8"})
    {
      Settings soft = {{"Young's modulus", "1e9"},
                       {"Poisson's ratio", "0.3"},
                       {"Cohesion", cohesion},
                       {"Friction", friction},
                       {"Cap start", "1e8"},
                       {"Cap pressure", "3e8"},
                       {"Cap hardening", friction[1] ? "1e8" : "0"}};
      const auto plane = make_law<2>("drucker_prager", soft);
      const auto space = make_law<3>("drucker_prager", soft);
      holds = LawProperties<2>(*plane).check() && holds;
      holds = LawProperties<3>(*space).check() && holds;
      holds = check_plane_strain(*plane, *space) && holds;
    }
  std::cout << "with and without friction every property holds: " << (holds ? "yes" : "no") << '\n';
}
