// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress, stress out of plane and energy of every law in plane strain against values worked out by hand:
// expected output from closed_forms.py, which shares no code with the laws. E = 1 MPa; nu = 0, 0.3, 0.4999.
#include "law_response.h"

#include <iomanip>
#include <iostream>

int main()
{
  using namespace softgrain;
  using namespace softgrain::test;
  const Tensor<2, 2> I = dealii::unit_symmetric_tensor<2>();
  Tensor<2, 2> uniaxial = I, pure_shear = I, simple_shear = I;
  uniaxial[0][0] = 1.5;
  pure_shear[0][0] = 1.25;
  pure_shear[1][1] = 0.8;
  simple_shear[0][1] = 0.5;
  const std::vector<std::pair<std::string, Tensor<2, 2>>> cases = {
      {"uniaxial", uniaxial}, {"pure_shear", pure_shear}, {"simple_shear", simple_shear}};
  for (const std::string name : {"hencky", "linear_elastic", "neo_hookean"})
    for (const std::string nu : {"0", "0.3", "0.4999"})
    {
      const auto law = make_law<2>(name, {{"Young's modulus", "1e6"}, {"Poisson's ratio", nu}});
      for (const auto &c : cases)
      {
        const Response<2> r = evaluate(*law, {I, c.second - I, initial_history(*law)});
        std::cout << name << ' ' << nu << ' ' << c.first << std::setprecision(12);
        for (const double value :
             {r.stress[0][0], r.stress[1][1], r.stress[0][1], r.out_of_plane_stress, r.energy})
          std::cout << ' ' << value;
        std::cout << '\n';
      }
    }
}
