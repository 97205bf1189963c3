// SPDX-License-Identifier: LGPL-2.1-or-later
// What every law must hold (tangent, symmetry, objectivity, energy, rest, batches, bad points), on every
// registered law.
#include "law_properties.h"

int main()
{
  using namespace softgrain;
  bool all = true;
  for (const std::string &name : constitutive::law_names())
    all = test::check_law(name) && all;
  // Not one line per law: a new law needs no new expectation.
  std::cout << "every law holds every property: " << (all ? "yes" : "no") << '\n';
  return all ? 0 : 1;
}
