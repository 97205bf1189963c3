// SPDX-License-Identifier: LGPL-2.1-or-later
// Three problems of Siconos (data/README.md): sweeps to its residual 1e-4, 1e-8, 1e-12 beside its own
// numbers, and the velocities at 1e-12 against its reference; then the same by Newton from a few sweeps.
#include <softgrain/base/exceptions.h>
#include <softgrain/contact/active_set.h>
#include <softgrain/contact/problem_io.h>
#include <softgrain/contact/residual.h>

#include "reference.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
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

Eigen::MatrixXd matrix_of(SavedProblem &saved)
{
  auto &operator_ = std::get<BlockDelassus>(saved.delassus);
  const unsigned int n = saved.problem.free_velocity.size();
  Eigen::MatrixXd W(n, n);
  std::vector<double> velocities;
  saved.problem.free_velocity.assign(n, 0.);
  for (unsigned int j = 0; j < n; ++j)
  {
    std::vector<double> unit(n, 0.);
    unit[j] = 1.;
    compute_velocities(operator_, saved.problem, unit, velocities);
    W.col(j) = Eigen::Map<Eigen::VectorXd>(velocities.data(), n);
  }
  return W;
}

/// What Siconos writes: dense with the sizes twice or once, triplets, columns, rows; largest difference when
/// read.
void other_storages(const std::string &original)
{
  SavedProblem saved = load_siconos_problem(original);
  const std::vector<double> q = saved.problem.free_velocity;
  const unsigned int n = q.size();
  const Eigen::MatrixXd W = matrix_of(saved);
  const auto try_matrix = [&](const std::string &name, const auto &write_matrix)
  {
    std::ofstream file("storage.dat");
    file << "2\n" << n / 2 << '\n' << std::setprecision(17);
    write_matrix(file);
    for (const double value : q)
      file << value << '\n';
    for (unsigned int i = 0; i < n / 2; ++i)
      file << "0.5\n";
    file.close();
    std::cout << name << ": ";
    try
    {
      SavedProblem again = load_siconos_problem("storage.dat");
      const bool same_q = again.problem.free_velocity == q;
      const double error = (matrix_of(again) - W).cwiseAbs().maxCoeff() / W.cwiseAbs().maxCoeff();
      std::cout << (error == 0.    ? "same"
                    : error < 1e-5 ? "six digits"
                                   : "WRONG")
                << ", q " << (same_q ? "same" : "WRONG") << '\n';
    }
    catch (const softgrain::InputError &error)
    {
      std::cout << error.what() << '\n';
    }
  };
  const auto dense = [n](std::ostream &file, const Eigen::MatrixXd &matrix, const bool sizes_twice)
  {
    file << "0\n" << n << '\n' << n << '\n';
    if (sizes_twice)
      file << n << '\t' << n << '\n';
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        file << matrix(i, j) << (i + 1 == n ? "\n" : " ");
  };
  const auto sparse = [&](std::ostream &file, const unsigned int origin)
  {
    const auto count = (W.array() != 0.).count();
    file << "2\n"
         << n << '\n'
         << n << '\n'
         << origin << "\nCSparse Version 4.0.2, Sept 20, 2022.  (c) T. Davis\n";
    if (origin == 1)
      file << "triplet: ";
    file << n << "-by-" << n << ", nzmax: " << count << " nnz: " << count
         << (origin == 1 ? "" : ", 1-norm: 7") << '\n'
         << std::setprecision(6);
    for (unsigned int j = 0; j < n; ++j)
    {
      if (origin != 1)
        file << "    col " << j << " : locations 0 to 1\n";
      for (unsigned int i = 0; i < n; ++i)
        if (W(i, j) != 0. && origin == 1)
          file << "    " << i << ' ' << j << " : " << W(i, j) << '\n';
        else if (W(i, j) != 0.)
          file << "      " << i << " : " << W(i, j) << '\n';
    }
    file << std::setprecision(17);
  };
  Eigen::MatrixXd skew = W;
  const double largest = W.cwiseAbs().maxCoeff();
  try_matrix("dense, sizes twice", [&](std::ostream &file) { dense(file, W, true); });
  try_matrix("dense, sizes once", [&](std::ostream &file) { dense(file, W, false); });
  for (const unsigned int origin : {1, 2, 3})
    try_matrix("sparse, kind " + std::to_string(origin), [&](std::ostream &file) { sparse(file, origin); });
  skew(3, 0) += 3e-7 * largest;
  try_matrix("asymmetry 3e-7", [&](std::ostream &file) { dense(file, skew, true); });
  skew(3, 0) += 1e-3 * largest;
  try_matrix("asymmetry 1e-3", [&](std::ostream &file) { dense(file, skew, true); });
  try_matrix("storage 7", [](std::ostream &file) { file << "7\n22\n22\n"; });
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
  other_storages(data + "FrictionContactProblem00031.dat");
}
