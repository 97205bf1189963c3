// SPDX-License-Identifier: LGPL-2.1-or-later
// softgrain-law-tester LIBRARY...: whether the laws of a library hold what every law must hold
// (doc/add-a-law.md).
#include <softgrain/base/exceptions.h>

#include <constitutive/law_library.h>

int main(const int argc, char **argv)
{
  if (argc < 2 || std::string(argv[1]).rfind("-", 0) == 0)
  {
    std::cerr << "usage: softgrain-law-tester LIBRARY...\nchecks the constitutive laws of shared libraries; "
                 "the manual, "
                 "add-a-law, says what is checked\n";
    return argc == 2 && (std::string(argv[1]) == "--help" || std::string(argv[1]) == "-h") ? 0 : 2;
  }
  bool good = true;
  try
  {
    for (int i = 1; i < argc; ++i)
      good = softgrain::test::check_library(argv[i]) && good;
  }
  catch (const softgrain::InputError &error)
  {
    std::cerr << "softgrain-law-tester: " << error.what() << '\n';
    return 2;
  }
  return good ? 0 : 1;
}
