// SPDX-License-Identifier: LGPL-2.1-or-later
// The measures and columns listed in doc/measures.md are those of the program, and no two columns have one
// name.
#include <softgrain/analysis/measure.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <regex>

int main()
{
  using namespace softgrain;
  std::ifstream page(SOFTGRAIN_SOURCE_DIR "/doc/measures.md");
  const std::regex heading("## `([a-z_]+)`.*"), row("\\| `([A-Za-z0-9_.]+)`(?: … `([A-Za-z0-9_.]+)`)? \\|.*");
  std::vector<std::string> documented, registered;
  std::smatch match;
  for (std::string line; std::getline(page, line);)
    if (std::regex_match(line, match, heading))
      documented.push_back("measure " + match[1].str());
    else if (std::regex_match(line, match, row))
      // The first and last of a row of columns stand for all of them.
      for (unsigned int m = 1; m <= 2 && match[m].matched; ++m)
        documented.push_back(match[m]);

  std::vector<std::string> columns;
  for (const std::string &name : Registry<Measure>::instance().names())
  {
    registered.push_back("measure " + name);
    const std::vector<std::string> own = MeasureSet({name}).columns();
    for (std::size_t i = 0; i < own.size(); ++i)
      if (i == 0 || i + 1 == own.size() || own[i].find("_at_") == std::string::npos ||
          own[i - 1].find("_at_") == std::string::npos)
        registered.push_back(own[i]);
    columns.insert(columns.end(), own.begin(), own.end());
  }
  std::sort(columns.begin(), columns.end());
  std::cout << "documented measures and columns are those of the program: "
            << (documented == registered ? "yes" : "no") << '\n'
            << "columns with one name: " << columns.end() - std::unique(columns.begin(), columns.end())
            << '\n';
  if (documented != registered)
    for (std::size_t i = 0; i < std::max(documented.size(), registered.size()); ++i)
      std::cout << (i < documented.size() ? documented[i] : "-") << " | "
                << (i < registered.size() ? registered[i] : "-") << '\n';
}
