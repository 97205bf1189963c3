// SPDX-License-Identifier: LGPL-2.1-or-later
// Three problems of Siconos (data/README.md): sweeps to its residual 1e-4, 1e-8, 1e-12 beside its own
// numbers, and the velocities at 1e-12 against its reference; then the same by Newton from a few sweeps.
#include <softgrain/contact/active_set.h>
#include <softgrain/contact/problem_io.h>
#include <softgrain/contact/residual.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>

using namespace softgrain::contact;

namespace
{
struct Reference
{
  std::vector<double> impulses, velocities;
};

Reference read_reference(const std::string &path, const unsigned int n)
{
  std::ifstream in(path);
  Reference reference;
  std::string title;
  std::getline(in, title); // "# rn rt un ut"
  for (unsigned int i = 0; i < n; ++i)
  {
    double rn, rt, un, ut;
    if (!(in >> rn >> rt >> un >> ut))
      throw std::runtime_error("reference " + path + " is too short");
    reference.impulses.insert(reference.impulses.end(), {rn, rt});
    reference.velocities.insert(reference.velocities.end(), {un, ut});
  }
  return reference;
}

double largest_difference(const std::vector<double> &a, const std::vector<double> &b)
{
  double worst = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
    worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

const char *verdict(const bool fine)
{
  return fine ? "yes" : "NO";
}
} // namespace

int main()
{
  const std::string data = SOFTGRAIN_TEST_DIR "/contact/data/";
  for (const std::string name : {"00031", "00237", "00727"})
  {
    SavedProblem saved = load_siconos_problem(data + "FrictionContactProblem" + name + ".dat");
    const Problem &problem = saved.problem;
    auto &W = std::get<BlockDelassus>(saved.delassus);
    const Reference reference = read_reference(
        data + "ref_FrictionContactProblem" + name + "_NSGS_tol1e-12.txt", problem.n_contacts());
    std::cout << name << ": " << problem.n_contacts() << " contacts\n";
    std::cout << "reference consistent with this residual: "
              << verdict(siconos_residual(problem, reference.impulses, reference.velocities) < 1.1e-12)
              << '\n';

    SolverSettings one_sweep;
    std::vector<double> impulses, velocities;
    unsigned int sweeps = 0;
    one_sweep.max_sweeps = 1;
    for (const double tolerance : {1e-4, 1e-8, 1e-12})
    {
      double residual = 1.;
      while (residual > tolerance && sweeps < 5000)
      {
        one_sweep.tolerance = 1e-30;
        gauss_seidel(W, problem, one_sweep, impulses, velocities);
        ++sweeps;
        residual = siconos_residual(problem, impulses, velocities);
      }
      std::cout << "sweeps to " << tolerance << ": " << sweeps << '\n';
    }
    std::cout << "velocities within 1e-8 of the reference: "
              << verdict(largest_difference(velocities, reference.velocities) < 1e-8) << '\n';

    SolverSettings settings;
    settings.tolerance = 1e-10;
    impulses.clear();
    const SolverReport report = solve(W, problem, settings, impulses, velocities);
    std::cout << "Newton iterations below 20: " << verdict(report.newton_iterations < 20)
              << ", sweeps at most 100: " << verdict(report.sweeps <= 100) << '\n';
    std::cout << "Newton converged: " << verdict(report.converged) << ", Siconos residual below 1e-10: "
              << verdict(siconos_residual(problem, impulses, velocities) < 1e-10)
              << ", velocities within 1e-7 of the reference: "
              << verdict(largest_difference(velocities, reference.velocities) < 1e-7) << '\n';
  }
}
