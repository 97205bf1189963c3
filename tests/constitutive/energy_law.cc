// SPDX-License-Identifier: LGPL-2.1-or-later
// A law that gives its energy alone against the same law with stress and tangent by hand.
#include "law_properties.h"
#include "modules/energy_only.cc"

namespace
{
using namespace softgrain::test;

template <int dim>
void compare()
{
  const auto exact = make_law<dim>("neo_hookean"), derived = make_law<dim>("energy_only");
  RandomNumbers random;
  double worst = 0;
  for (unsigned int i = 0; i < 200; ++i)
  {
    Tensor<2, dim> L = random.tensor<dim>(i < 100 ? 0.1 : 0.6);
    const Step<dim> step = {dealii::unit_symmetric_tensor<dim>(), L, {}};
    if (determinant(step.F()) < 0.05)
      continue;
    const Response<dim> a = evaluate(*exact, step), b = evaluate(*derived, step);
    const double scale = a.tangent.norm() + a.stress.norm();
    worst = std::max({worst, (a.stress - b.stress).norm() / scale, (a.tangent - b.tangent).norm() / scale,
                      std::abs(a.out_of_plane_stress - b.out_of_plane_stress) / scale,
                      std::abs(a.energy - b.energy) / scale});
  }
  std::cout << dim << "D, the same as neo_hookean to 1e-13: " << (worst < 1e-13 ? "yes" : "no") << '\n';
}
} // namespace

int main()
{
  compare<2>();
  compare<3>();
  std::cout << "holds every property: " << (check_law("energy_only") ? "yes" : "no") << '\n';
}
