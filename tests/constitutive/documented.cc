// SPDX-License-Identifier: LGPL-2.1-or-later
// The laws listed in doc/add-a-law.md are the laws of the program, with the same subsections: a law that the
// linker dropped or nobody documented shows here.
#include <softgrain/constitutive/law_registry.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <regex>

int main()
{
  using namespace softgrain;
  std::ifstream page(SOFTGRAIN_SOURCE_DIR "/doc/add-a-law.md");
  const std::regex row("\\| `([a-z0-9_]+)` \\| ([^|]+) \\|.*");
  std::vector<std::string> documented, registered;
  std::smatch match;
  for (std::string line; std::getline(page, line);)
    if (std::regex_match(line, match, row))
      documented.push_back(match[1].str() + " (" + match[2].str() + ")");
  std::sort(documented.begin(), documented.end());
  for (const std::string &name : constitutive::law_names())
    registered.push_back(name + " (" + Registry<constitutive::Law<2>>::instance().create(name)->title() +
                         ")");

  const bool same = documented == registered;
  const bool same_in_3d = constitutive::law_names() == Registry<constitutive::Law<3>>::instance().names();
  std::cout << "documented laws are the registered ones: " << (same ? "yes" : "no") << '\n'
            << "laws in 2D are those in 3D: " << (same_in_3d ? "yes" : "no") << '\n';
  if (!same)
    std::cout << "documented: " << join(documented) << "\nregistered: " << join(registered) << '\n';
  return same && same_in_3d ? 0 : 1;
}
