// SPDX-License-Identifier: LGPL-2.1-or-later
// The example of a law in a shared library: loaded as a user loads it, it holds what every law must hold.
#include "law_library.h"

#include <fstream>
#include <sstream>

namespace
{
/// The example with another interface in its mark is refused before anything of it runs.
void of_another_interface(const std::string &mark)
{
  std::ostringstream content;
  content << std::ifstream(SOFTGRAIN_CUSTOM_LAW, std::ios::binary).rdbuf();
  std::string bytes = content.str();
  const std::string ours = softgrain::plugin_interface_mark;
  for (std::size_t place = bytes.find(ours); place != std::string::npos; place = bytes.find(ours))
    bytes.replace(place, ours.size(), mark.substr(0, ours.size()));
  std::ofstream("older.so", std::ios::binary) << bytes;
  try
  {
    softgrain::constitutive::load_libraries({"./older.so"});
    std::cout << "accepted\n";
  }
  catch (const softgrain::InputError &error)
  {
    std::cout << error.what() << '\n';
  }
}
} // namespace

int main()
{
  using namespace softgrain;
  const bool good = test::check_library(SOFTGRAIN_CUSTOM_LAW);

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
    std::cout << text.substr(text.rfind(": registered") + 2) << '\n';
  }

  of_another_interface("softgrain plug-in interface 1.");
  of_another_interface("no mark, as libraries have of 0.1");
  return good ? 0 : 1;
}
