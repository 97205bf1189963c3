// SPDX-License-Identifier: LGPL-2.1-or-later
// A saved problem, loaded and replayed, gives the same impulses to the last bit, for every operator.
#include "reference.h"

#include <softgrain/base/exceptions.h>
#include <softgrain/contact/active_set.h>
#include <softgrain/contact/problem_io.h>

#include <cstdio>
#include <fstream>
#include <iostream>

using namespace softgrain;
using namespace softgrain::contact;

namespace
{
template <class Operator>
void round_trip(const std::string &title, Operator &W, const Problem &problem, const SolverSettings &settings)
{
  std::vector<double> warm(problem.free_velocity.size()), w, again, w_again;
  for (unsigned int i = 0; i < warm.size(); ++i)
    warm[i] = i % problem.n_components == 0 ? 1. / (3. + i) : 0.;
  const std::string path = title + ".h5";
  save_problem(path, W, problem, settings, warm, "step 7, t = 0.1 s, " + title);

  const SavedProblem saved = load_problem(path);
  std::cout << title << ": same warm start " << verdict(saved.impulses == warm) << ", same q "
            << verdict(saved.problem.free_velocity == problem.free_velocity) << ", same mu "
            << verdict(saved.problem.friction == problem.friction) << ", same settings "
            << verdict(saved.settings.tolerance == settings.tolerance &&
                       saved.settings.max_sweeps == settings.max_sweeps &&
                       saved.settings.algorithm == settings.algorithm &&
                       saved.settings.relaxation == settings.relaxation)
            << ", description '" << saved.description << "', nothing left beside it "
            << verdict(!std::ifstream(path + ".tmp")) << '\n';
  std::vector<double> P = warm;
  const SolverReport report = solve(W, problem, settings, P, w);
  const SolverReport replayed = replay(path, again, w_again);
  std::cout << "  replayed: same impulses to the bit " << verdict(P == again) << ", same velocities "
            << verdict(w == w_again) << ", same sweeps " << verdict(report.sweeps == replayed.sweeps)
            << ", moved from the warm start " << verdict(P != warm) << '\n';
}

void expect_error(const std::string &title, const std::string &path)
{
  try
  {
    load_problem(path);
    std::cout << title << ": nothing thrown\n";
  }
  catch (const InputError &error)
  {
    std::cout << title << ": " << error.what() << '\n';
  }
}
} // namespace

int main()
{
  BlockDelassus blocks = random_bodies(8, 3, 2, 10., 5);
  Problem problem{2, {}, std::vector<double>(blocks.n_contacts(), 1. / 3.)};
  SolverSettings settings;
  for (unsigned int i = 0; i < 2 * blocks.n_contacts(); ++i)
    problem.free_velocity.push_back(-0.3 - std::sin(1. + i));
  settings.tolerance = 1e-11;
  settings.algorithm = Algorithm::active_set;
  round_trip("blocks", blocks, problem, settings);
  settings.algorithm = Algorithm::gauss_seidel;
  settings.max_sweeps = 3; // a problem that failed is what is saved
  round_trip("blocks_failed", blocks, problem, settings);

  MassDelassus masses(1, {0, 1, 3, 5}, {0, 1, 0, 2, 1}, {1., 1., -1., 1., -1.}, {1. / 3., 1. / 7., 1. / 9.});
  round_trip("mass", masses, {1, {-1., -0.1, 0.05}, {}}, SolverSettings());
  DiagonalDelassus diagonal(2, {2., 0.1, 0.1, 1., 3., 0., 0., 1.});
  round_trip("diagonal", diagonal, {2, {-1., 0.3, -0.2, 0.}, {0.2, 0.3}}, SolverSettings());

  expect_error("missing", "missing.h5");
  std::ofstream("text.h5") << "this is not HDF5\n";
  expect_error("no HDF5", "text.h5");
  {
    std::ifstream in("blocks.h5", std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    std::ofstream("cut.h5", std::ios::binary) << bytes.substr(0, bytes.size() / 2);
  }
  expect_error("cut in half", "cut.h5");
  try
  {
    save_problem("no/such/folder/file.h5", blocks, problem, settings, {}, "");
    std::cout << "nothing thrown\n";
  }
  catch (const ComputationError &error)
  {
    std::cout << error.what() << '\n';
  }
}
