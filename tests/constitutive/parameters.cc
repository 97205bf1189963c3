// SPDX-License-Identifier: LGPL-2.1-or-later
// What a user is told about a wrong parameter of a law, a wrong name and a library that cannot be loaded.
#include "law_response.h"

#include <softgrain/constitutive/load_libraries.h>

#include <fstream>
#include <functional>
#include <iostream>
#include <regex>

int main()
{
  using namespace softgrain;
  const auto show = [](const std::function<void()> &action)
  {
    try
    {
      action();
      std::cout << "accepted\n";
    }
    catch (const InputError &error)
    {
      // without the list of all laws, which grows
      std::cout << std::regex_replace(error.what(), std::regex("known are: [a-z0-9_, ]*[a-z]"),
                                      "known are: ...")
                << '\n';
    }
    catch (const dealii::ExceptionBase &)
    {
      std::cout << "outside the pattern\n";
    }
  };
  using Settings = std::vector<std::pair<std::string, std::string>>;
  for (const Settings &settings :
       {Settings{{"Poisson's ratio", "0.5"}}, Settings{{"Poisson's ratio", "-1"}},
        Settings{{"Poisson's ratio", "0.6"}}, Settings{{"Poisson's ratio", "-0.9"}},
        Settings{{"Young's modulus", "0"}}, Settings{{"Young's modulus", "-1"}},
        Settings{{"Young's modulus", "1e-3"}}})
  {
    std::cout << settings[0].first << " = " << settings[0].second << ": ";
    show([&] { test::make_law<2>("neo_hookean", settings); });
  }

  dealii::ParameterHandler prm;
  constitutive::declare_all_laws(prm);
  for (const std::string name : {"neo_hokean", "Hencky", "banana", ""})
    show([&] { constitutive::create_law<2>(name, prm); });
  // After an error the handler stands where it stood, so that the next law can be read.
  prm.enter_subsection("Hencky");
  prm.set("Poisson's ratio", "0.5");
  prm.leave_subsection();
  show([&] { constitutive::create_law<3>("hencky", prm); });
  show([&] { constitutive::create_law<3>("linear_elastic", prm); });

  // A law that is registered twice is reported once, when somebody asks for laws.
  show([] { check_registrations(); });
  note_failed_registration("registered twice: hencky");
  show([] { check_registrations(); });
  show([] { check_registrations(); });

  show([] { constitutive::load_libraries({}); });
  // The loader's own words differ between systems, so only ours are printed.
  std::ofstream("not_a_library.so") << "text";
  for (const std::string path : {"no_such_library.so", "not_a_library.so"})
    show(
        [&]
        {
          try
          {
            constitutive::load_libraries({path});
          }
          catch (const InputError &error)
          {
            const std::string text = error.what();
            const std::string ours = "cannot be loaded: ";
            const std::size_t end = text.find(ours) + ours.size();
            throw InputError(text.substr(0, end) + (text.size() > end ? "(reason)" : "(no reason)"));
          }
        });
}
