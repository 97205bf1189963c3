// SPDX-License-Identifier: LGPL-2.1-or-later
// A run interrupted by a signal and continued, and continued once more, leaves the history of one that never
// stopped; a failed step saves the last good state.
#include "stub_model.h"
#include <softgrain/base/mpi_session.h>

#include <nlohmann/json.hpp>

#include <filesystem>

namespace
{
std::string content(const std::string &path)
{
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::string status(const std::string &directory)
{
  const auto summary = nlohmann::json::parse(std::ifstream(directory + "/summary.json"));
  return summary["status"].get<std::string>() + " after " + std::to_string(summary["steps"].get<int>());
}
} // namespace

int main(int, char **argv)
{
  using namespace softgrain;
  const softgrain::MPISession mpi(argv);
  write_text("scene.prm", std::string(stub_scene) +
                              "subsection Output\n set Fields every = 0.095\n set History every = 4\nend\n");
  softgrain_command({"run", "scene.prm", "--output", "whole"});

  std::cout << softgrain_command(
                   {"run", "scene.prm", "--output", "parts", "--set", "Stub/Stopped at step=33"})
            << ' ' << status("parts") << '\n';
  // Rows after the checkpoint, as a crash leaves them, are cut off; so is half a row.
  write_text("parts/history.csv", content("parts/history.csv") + "0.34,34,0\n0.35,3");
  std::cout << softgrain_command(
                   {"run", "scene.prm", "--output", "parts", "--restart", "--set", "Stub/Stopped at step=60"})
            << ' ' << status("parts") << '\n';
  std::cout << softgrain_command({"run", "scene.prm", "--output", "parts", "--restart"}) << ' '
            << status("parts") << '\n';
  std::cout << "history "
            << (content("whole/history.csv") == content("parts/history.csv") ? "same" : "differs")
            << "\npictures "
            << (content("whole/fields.pvd") == content("parts/fields.pvd") ? "same" : "differ") << '\n';
  unsigned int n_states = 0;
  for (const auto &entry : std::filesystem::directory_iterator("parts"))
    n_states += entry.path().extension() == ".h5";
  std::cout << "checkpoints " << n_states << '\n';

  std::cout << softgrain_command({"run", "scene.prm", "--output", "failing", "--set", "Stub/Fails at step=7"})
            << ' ' << status("failing") << '\n';
  std::cout << softgrain_command({"run", "scene.prm", "--output", "failing", "--restart"}) << ' '
            << status("failing") << '\n';
  std::cout << "history "
            << (content("whole/history.csv") == content("failing/history.csv") ? "same" : "differs") << '\n';
  std::cout << softgrain_command({"run", "scene.prm", "--output", "nowhere", "--restart"}) << '\n';
}
