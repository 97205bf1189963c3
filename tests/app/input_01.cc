// SPDX-License-Identifier: LGPL-2.1-or-later
// Reading a parameter file checks all it can and computes nothing: disks are packed when the scene is
// completed, and a wrong setting of the model is told before that.
#include <softgrain/app/input.h>
#include <softgrain/base/exceptions.h>

#include <filesystem>
#include <fstream>
#include <iostream>

using namespace softgrain;

namespace
{
const char *const scene = R"(
subsection Materials
  set Names = gel
end
subsection Packing
  set Number            = 5
  set Smallest diameter = 0.2
  set Largest diameter  = 0.2
  set Upper             = 1, 1
  set Save to           = packing.csv
end
subsection Stop
  set End time = 1
end
)";

void look(std::vector<std::string> changes)
{
  changes.push_back("Output directory=results");
  std::filesystem::remove("packing.csv");
  try
  {
    Input input("scene.prm", changes);
    std::cout << "read: " << input.scene().bodies.size() << " bodies, file "
              << (std::filesystem::exists("packing.csv") ? "written" : "not there") << '\n';
    input.complete_scene();
    input.complete_scene();
    std::cout << "completed: " << input.scene().bodies.size() << " bodies, file "
              << (std::filesystem::exists("packing.csv") ? "written" : "not there") << '\n';
    input.save_packing(false);
    input.save_packing(false); // the same contents
    std::cout << "saved: file " << (std::filesystem::exists("packing.csv") ? "written" : "not there") << '\n';
    std::ofstream("packing.csv") << "precious";
    input.save_packing(true);
    std::cout << "bytes: " << (std::filesystem::file_size("packing.csv") > 100 ? "of a packing" : "others")
              << '\n';
    std::ofstream("packing.csv") << "precious";
    input.save_packing(false);
  }
  catch (const InputError &error)
  {
    std::cout << error.what() << '\n';
  }
}
} // namespace

int main()
{
  std::ofstream("scene.prm") << scene;
  look({});
  look({"Packing/Number=40"});
  look({"Packing/Number=40", "Contact/Geometry=nodes"});
  look({"Packing/Method=file"});
  look({"Packing/Method=random", "Packing/Number=0"});
}
