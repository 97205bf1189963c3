// SPDX-License-Identifier: LGPL-2.1-or-later
// Follows the paths of saved contact problems ('Contact/Keep failed problems in'): exchanges, residual and
// processor time.
#include <softgrain/contact/path_following.h>
#include <softgrain/contact/problem_io.h>
#include <softgrain/contact/residual.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>

using namespace softgrain::contact;

int main(const int argc, char **argv)
{
  std::printf("%-28s %8s %9s %10s %9s %12s\n", "problem", "contacts", "exchanges", "residual", "ms",
              "ms/exchange");
  try
  {
    for (int i = 1; i < argc; ++i)
    {
      const SavedProblem saved = load_problem(argv[i]);
      BlockDelassus W = std::get<BlockDelassus>(saved.delassus);
      std::vector<double> P = saved.impulses;
      W.begin(P);
      const std::vector<double> compliance = contact_compliance(W);
      SolverReport report;
      const std::clock_t begin = std::clock();
      const double residual = follow_path(W.assemble(), saved.problem, compliance, saved.settings, P, report);
      const double time = 1e3 * (std::clock() - begin) / CLOCKS_PER_SEC;
      const std::string path = argv[i];
      std::printf("%-28s %8u %9u %10.1e %9.1f %12.3f\n", path.substr(path.find_last_of('/') + 1).c_str(),
                  W.n_contacts(), report.newton_iterations, residual, time,
                  time / std::max(1u, report.newton_iterations));
    }
  }
  catch (const std::exception &error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
