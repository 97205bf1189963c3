// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_constitutive_law_library_h
#define softgrain_tests_constitutive_law_library_h

#include "law_properties.h"

#include <softgrain/base/nearest_name.h>
#include <softgrain/constitutive/load_libraries.h>

#include <algorithm>
#include <string>
#include <vector>

namespace softgrain::test
{
/// Loads a library as a user does and checks every law that it brings. @return whether there are any and all
/// hold
inline bool check_library(const std::string &library)
{
  const std::vector<std::string> before = constitutive::law_names();
  constitutive::load_libraries({library});
  constitutive::load_libraries({library, library}); // more than once is once
  std::vector<std::string> brought;
  for (const std::string &name : constitutive::law_names())
    if (std::find(before.begin(), before.end(), name) == before.end())
      brought.push_back(name);
  std::cout << "laws in the library: " << join(brought) << '\n';
  bool good = !brought.empty();
  for (const std::string &name : brought)
    good = check_law(name) && good;
  std::cout << "every law holds every property: " << (good ? "yes" : "no") << '\n';
  return good;
}
} // namespace softgrain::test

#endif
