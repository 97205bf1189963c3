// SPDX-License-Identifier: LGPL-2.1-or-later
// The example of a law in a shared library: loaded as a user loads it, it holds what every law must hold.
// With an argument, the laws of the library of that path are checked instead.
#include "law_properties.h"

#include <softgrain/constitutive/load_libraries.h>

#include <algorithm>

int main(int argc, char **argv)
{
  using namespace softgrain;
  const std::vector<std::string> before = constitutive::law_names();
  const std::string library = argc > 1 ? argv[1] : SOFTGRAIN_CUSTOM_LAW;
  constitutive::load_libraries({library});
  constitutive::load_libraries({library, library}); // more than once is once
  std::vector<std::string> brought;
  for (const std::string &name : constitutive::law_names())
    if (std::find(before.begin(), before.end(), name) == before.end())
      brought.push_back(name);
  std::cout << "laws in the library: " << join(brought) << '\n';
  bool good = !brought.empty();
  for (const std::string &name : brought)
    good = test::check_law(name) && good;
  std::cout << "every law holds every property: " << (good ? "yes" : "no") << '\n';
  if (argc > 1)
    return good ? 0 : 1;

  // Without stiffening it is neo-Hookean.
  const auto fung = test::make_law<2>("fung", {{"Stiffening", "0"}}),
             neo_hookean = test::make_law<2>("neo_hookean");
  test::RandomNumbers random;
  const test::Step<2> step = {dealii::unit_symmetric_tensor<2>(), random.tensor<2>(0.3), {}};
  const auto a = test::evaluate(*fung, step), b = test::evaluate(*neo_hookean, step);
  std::cout << "k = 0 is neo-Hookean: "
            << ((a.stress - b.stress).norm() + std::abs(a.energy - b.energy) < 1e-12 * b.tangent.norm())
            << '\n';

  // Another library that brings the same name is refused.
  try
  {
    constitutive::load_libraries({SOFTGRAIN_CUSTOM_LAW_TWICE});
    std::cout << "accepted\n";
  }
  catch (const InputError &error)
  {
    const std::string text = error.what();
    std::cout << text.substr(text.rfind(": constitutive") + 2) << '\n';
  }
  return good ? 0 : 1;
}
