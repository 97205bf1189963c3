// SPDX-License-Identifier: LGPL-2.1-or-later
// A run takes the measures it is asked for with its snapshots; interrupted and continued it has the table of
// one that never stopped, and `measure` makes the same table from the snapshots.
#include "stub_model.h"
#include <softgrain/base/mpi_session.h>

#include <softgrain/analysis/measure.h>

namespace
{
std::string content(const std::string &path)
{
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}
} // namespace

int main(int, char **argv)
{
  using namespace softgrain;
  const softgrain::MPISession mpi(argv);
  write_text("scene.prm", std::string(stub_scene) + "subsection Output\n set Snapshots every = 0.4\n"
                                                    " set Measures = energies, packing\nend\n");
  softgrain_command({"run", "scene.prm", "--output", "whole"});
  std::cout << content("whole/measures.csv");

  softgrain_command({"run", "scene.prm", "--output", "parts", "--set", "Stub/Stopped at step=60"});
  softgrain_command({"run", "scene.prm", "--output", "parts", "--restart"});
  std::cout << (content("whole/measures.csv") == content("parts/measures.csv") ? "the same" : "another")
            << " table after a stop\n";
  std::cout << softgrain_command(
                   {"run", "scene.prm", "--output", "parts", "--restart", "--set", "Output/Measures=packing"})
            << '\n';

  std::string printed;
  std::cout << softgrain_command(
                   {"measure", "whole", "--output", "again/m.csv", "--measures", "energies,packing"},
                   &printed)
            << ' ' << printed
            << (content("whole/measures.csv") == content("again/m.csv") ? "the same" : "another")
            << " table from the snapshots\n";
  std::cout << softgrain_command({"measure", "whole"}) << '\n';
  const std::string all = content("whole/measures.csv");
  const std::size_t n_columns = std::count(all.begin(), all.begin() + all.find('\n'), ',') + 1;
  std::cout << "all columns: " << (n_columns == 2 + MeasureSet({"all"}).columns().size() ? "yes" : "no")
            << '\n';
  std::cout << softgrain_command({"measure", "whole", "--measures", "packin"}) << '\n'
            << softgrain_command({"measure", "nowhere"}) << '\n'
            << softgrain_command({"measure", "again"}) << '\n';
}
