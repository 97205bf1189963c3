// SPDX-License-Identifier: LGPL-2.1-or-later
// A model that does not know of other ranks, as those from outside may be. Known: it is refused on two, with
// exit code 2 and one line, and nothing is written.
#include "stub_model.h"

#include <softgrain/base/mpi_session.h>
#include <softgrain/base/ranks.h>

#include <filesystem>
#include <iostream>

int main(int, char **argv)
{
  using namespace softgrain;
  const MPISession mpi(argv);
  const Ranks ranks;
  ranks.at_first([]() { write_text("scene.prm", stub_scene); });
  const int exit_code = softgrain_command({"run", "scene.prm", "--output", "on_ranks"});
  if (ranks.first())
    std::cout << exit_code << (std::filesystem::exists("on_ranks") ? " wrote a folder" : " wrote nothing")
              << '\n';
}
