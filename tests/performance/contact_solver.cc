// SPDX-License-Identifier: LGPL-2.1-or-later
// Solves saved contact problems ('Contact/Keep failed problems in') with every algorithm: sweeps, Newton
// iterations, residual and time.
#include <softgrain/contact/active_set.h>
#include <softgrain/contact/problem_io.h>

#include <chrono>
#include <cstdio>
#include <exception>

using namespace softgrain::contact;

int main(const int argc, char **argv)
{
  std::printf("%-28s %10s %-12s %7s %7s %10s %9s\n", "problem", "components", "algorithm", "sweeps", "newton",
              "residual", "ms");
  try
  {
    for (int i = 1; i < argc; ++i)
    {
      const SavedProblem saved = load_problem(argv[i]);
      for (const auto &[name, algorithm] : algorithms())
      {
        SavedProblem again = saved;
        again.settings.algorithm = algorithm;
        std::vector<double> impulses, velocities;
        const auto begin = std::chrono::steady_clock::now();
        const SolverReport report = replay(again, impulses, velocities);
        const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
        const std::string path = argv[i];
        std::printf("%-28s %10zu %-12s %7u %7u %10.1e %9.1f\n",
                    path.substr(path.find_last_of('/') + 1).c_str(), saved.impulses.size(), name.c_str(),
                    report.sweeps, report.newton_iterations, report.residual, time.count());
      }
    }
  }
  catch (const std::exception &error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
