// SPDX-License-Identifier: LGPL-2.1-or-later
// A whole run with a stub model: columns of the history, pictures at exact times, what the summary says.
#include "stub_model.h"
#include <softgrain/base/mpi_session.h>

#include <nlohmann/json.hpp>

#include <filesystem>

int main(int, char **argv)
{
  using namespace softgrain;
  const softgrain::MPISession mpi(argv);
  write_text("scene.prm", stub_scene);
  std::cout << "exit code "
            << softgrain_command({"run", "scene.prm", "--output", "out", "--set", "Stub/Time step = 0.03",
                                  "--set", "Output/Number of field outputs = 4", "--set",
                                  "Output/History every=5"})
            << '\n';

  std::ifstream history("out/history.csv");
  for (std::string line; std::getline(history, line);)
    std::cout << line << '\n';

  std::ifstream index("out/fields.pvd");
  for (std::string line; std::getline(index, line);)
    if (line.find("name=\"walls\"") != std::string::npos)
      std::cout << line.substr(line.find("timestep"), line.find("part") - line.find("timestep")) << '\n';

  const auto summary = nlohmann::ordered_json::parse(std::ifstream("out/summary.json"));
  for (const auto &item : summary.items())
  {
    const std::string &key = item.key();
    std::cout << key;
    if (key == "status" || key == "model" || key == "steps" || key == "simulated_time_s" || key == "bodies" ||
        key == "material_points" || key == "max_contact_residual" || key == "momentum_error")
      std::cout << " = " << item.value();
    if (key == "energy_balance_error")
      std::cout << (item.value().get<double>() < 1e-13 ? " is rounding" : " is large");
    std::cout << '\n';
  }

  // What was used repeats the run.
  std::cout << "again " << softgrain_command({"run", "out/parameters.prm", "--output", "again"}) << '\n';
  std::ifstream first("out/history.csv"), second("again/history.csv");
  std::ostringstream a, b;
  a << first.rdbuf();
  b << second.rdbuf();
  std::cout << (a.str() == b.str() ? "the same history" : "another history") << '\n';
  // A strain of ln(1/0.95) is reached at t = 0.5, a packing of pi/4/0.95 too.
  for (const std::string stop : {"Stop/Axial strain=0.0512", "Stop/Packing fraction=0.8266"})
  {
    std::cout << softgrain_command(
        {"run", "scene.prm", "--output", "stop", "--overwrite", "--set", stop, "--set", "Stop/End time=0"});
    std::cout << ' ' << nlohmann::json::parse(std::ifstream("stop/summary.json"))["simulated_time_s"] << '\n';
  }
  // Foreign files are never mixed with results.
  std::filesystem::create_directory("mine");
  write_text("mine/letter.txt", "dear");
  std::cout << softgrain_command({"run", "scene.prm", "--output", "mine"}) << '\n';
}
