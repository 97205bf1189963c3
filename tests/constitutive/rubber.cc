// SPDX-License-Identifier: LGPL-2.1-or-later
// Rubbers at constant volume against the textbook forms of uniaxial and equibiaxial tension and simple shear.
// Differences of normal stresses do not depend on the volumetric part. E = 1 MPa, nu = 0.49; expected output
// from rubber.py, which shares no code with the laws. Then Gent's locking, and plane strain.
#include "law_response.h"

#include <cmath>
#include <iomanip>
#include <iostream>

namespace
{
using namespace softgrain;
using namespace softgrain::test;

const std::vector<std::pair<std::string, std::string>> rest = {{"Young's modulus", "1e6"},
                                                               {"Poisson's ratio", "0.49"}};

std::unique_ptr<Law<3>> rubber(const std::string &name,
                               const std::vector<std::pair<std::string, std::string>> &own)
{
  auto settings = rest;
  settings.insert(settings.end(), own.begin(), own.end());
  return make_law<3>(name, settings);
}

Response<3> answer(const Law<3> &law, const Tensor<2, 3> &F)
{
  return evaluate(law, {F, {}, initial_history(law)});
}

/// lambda along x, mean along y, the rest along z.
Tensor<2, 3> stretch(const double x, const double y)
{
  Tensor<2, 3> F;
  F[0][0] = x;
  F[1][1] = y;
  F[2][2] = 1 / (x * y);
  return F;
}
} // namespace

int main()
{
  std::cout << std::setprecision(10);
  const std::vector<std::pair<std::string, std::vector<std::pair<std::string, std::string>>>> laws = {
      {"mooney_rivlin", {{"Share of the second invariant", "0.3"}}},
      {"gent", {{"Locking", "30"}}},
      {"yeoh", {{"Second coefficient", "-0.02"}, {"Third coefficient", "4e-4"}}},
      {"ogden", {{"Exponents", "1.3, 5, -2"}, {"Weights", "8.19, 0.06, 0.2"}}}};
  for (const auto &entry : laws)
  {
    const auto law = rubber(entry.first, entry.second);
    const double lambda = 2.5, gamma = 1.5;
    const auto uniaxial = answer(*law, stretch(lambda, 1 / std::sqrt(lambda))).stress;
    const auto equibiaxial = answer(*law, stretch(lambda, lambda)).stress;
    Tensor<2, 3> F = dealii::unit_symmetric_tensor<3>();
    F[0][1] = gamma;
    const auto shear = answer(*law, F).stress;
    std::cout << entry.first << " uniaxial " << uniaxial[0][0] - uniaxial[1][1] << '\n'
              << entry.first << " equibiaxial " << equibiaxial[0][0] - equibiaxial[2][2] << '\n'
              << entry.first << " shear " << shear[0][1] << ' ' << shear[0][0] - shear[1][1] << '\n';
  }

  // At I1 - 3 = J_m (1 - d) the stress of Gent is 1 / d times that of the neo-Hookean solid; beyond J_m there
  // is none.
  const auto gent = rubber("gent", {{"Locking", "4"}});
  Tensor<2, 3> F = dealii::unit_symmetric_tensor<3>();
  for (const double distance : {1e-1, 1e-3, 1e-6})
  {
    F[0][1] = std::sqrt(4 * (1 - distance));
    std::cout << "gent at a distance of " << distance
              << " from locking: " << answer(*gent, F).stress[0][1] * distance / (F[0][1] * 1e6 / 2.98)
              << '\n';
  }
  for (const double gamma : {2., 2.1, 10.})
  {
    F[0][1] = gamma;
    std::cout << "gent, shear " << gamma << ", good points: " << answer(*gent, F).n_good << '\n';
  }

  // In plane strain the second invariant is the first but for the volume: the plane does not see its share.
  Tensor<2, 2> G = dealii::unit_symmetric_tensor<2>();
  G[0][0] = 1.7;
  G[0][1] = 0.4;
  Response<2> r[2];
  for (unsigned int i = 0; i < 2; ++i)
  {
    auto settings = rest;
    settings.push_back({"Share of the second invariant", i == 0 ? "0" : "0.8"});
    const auto law = make_law<2>("mooney_rivlin", settings);
    r[i] = evaluate(*law, {G, {}, initial_history(*law)});
  }
  std::cout << "mooney_rivlin, stress in the plane depends on the share: "
            << ((r[0].stress - r[1].stress).norm() < 1e-12 * r[0].tangent.norm() ? "no" : "yes") << '\n'
            << "mooney_rivlin, stress out of plane depends on the share: "
            << (std::abs(r[0].out_of_plane_stress - r[1].out_of_plane_stress) < 1e4 ? "no" : "yes") << '\n';
}
