// SPDX-License-Identifier: LGPL-2.1-or-later
// Independent solvers and checks that the tests of the contact kernel share.
#ifndef softgrain_tests_contact_reference_h
#define softgrain_tests_contact_reference_h

#include <softgrain/contact/block_delassus.h>
#include <softgrain/contact/problem.h>

#include <Eigen/Dense>

#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

/// Lemke's complementary pivoting for w = M z + q, w, z >= 0, z.w = 0 (Cottle, Pang, Stone 1992,
/// algorithm 4.4.5).
inline Eigen::VectorXd lemke(const Eigen::MatrixXd &M, const Eigen::VectorXd &q)
{
  const int n = q.size();
  if (q.minCoeff() >= 0.)
    return Eigen::VectorXd::Zero(n);
  // columns: w (0..n-1), z (n..2n-1), z0 (2n), right side
  Eigen::MatrixXd table(n, 2 * n + 2);
  table << Eigen::MatrixXd::Identity(n, n), -M, -Eigen::VectorXd::Ones(n), q;
  std::vector<int> basis(n);
  std::iota(basis.begin(), basis.end(), 0);
  int row;
  q.minCoeff(&row);
  int entering = 2 * n;
  for (int iteration = 0; iteration < 100 * n; ++iteration)
  {
    const int leaving = basis[row];
    table.row(row) /= double(table(row, entering));
    for (int i = 0; i < n; ++i)
      if (i != row)
        table.row(i) -= double(table(i, entering)) * table.row(row).eval();
    basis[row] = entering;
    if (leaving == 2 * n)
    {
      Eigen::VectorXd z = Eigen::VectorXd::Zero(n);
      for (int i = 0; i < n; ++i)
        if (basis[i] >= n && basis[i] < 2 * n)
          z[basis[i] - n] = table(i, 2 * n + 1);
      return z;
    }
    entering = leaving < n ? leaving + n : leaving - n;
    double best = std::numeric_limits<double>::infinity();
    row = -1;
    for (int i = 0; i < n; ++i)
      if (table(i, entering) > 1e-12 && table(i, 2 * n + 1) / table(i, entering) < best)
      {
        best = table(i, 2 * n + 1) / table(i, entering);
        row = i;
      }
    if (row < 0)
      throw std::runtime_error("Lemke: ray");
  }
  throw std::runtime_error("Lemke: too many pivots");
}

/// Worst violation of Signorini and Coulomb over all contacts, condition by condition, as a velocity (m/s).
inline double worst_violation(const softgrain::contact::Problem &problem,
                              const Eigen::MatrixXd &W,
                              const std::vector<double> &impulses)
{
  const unsigned int n = problem.n_components;
  const Eigen::VectorXd P = Eigen::Map<const Eigen::VectorXd>(impulses.data(), impulses.size());
  const Eigen::VectorXd w =
      W * P + Eigen::Map<const Eigen::VectorXd>(problem.free_velocity.data(), problem.free_velocity.size());
  double worst = 0.;
  for (unsigned int i = 0; i < problem.n_contacts(); ++i)
  {
    const double trace = W.diagonal().segment(i * n, n).mean();
    const double wn = w[i * n], pn = P[i * n] * trace;
    worst = std::max({worst, -wn, -pn, std::min(std::abs(wn), std::abs(pn))});
    if (n > 1)
    {
      const Eigen::VectorXd wt = w.segment(i * n + 1, n - 1), pt = P.segment(i * n + 1, n - 1) * trace;
      const double cone = problem.friction[i] * pn;
      worst = std::max(worst, pt.norm() - cone);
      worst = std::max(worst, std::min(wt.norm(), cone - pt.norm()));
      // opposed to the slip: the friction's power is -mu P_n |w_t|
      if (cone > 0.)
        worst = std::max(worst, (pt.dot(wt) + pt.norm() * wt.norm()) / cone);
    }
  }
  return worst;
}

/// Bodies in a ring or chain: every body has a dense random block on the contacts of its own, plus c g gᵀ
/// (rigid mode).
inline softgrain::contact::BlockDelassus random_bodies(const unsigned int n_bodies,
                                                       const unsigned int contacts_per_pair,
                                                       const unsigned int n_components,
                                                       const double rigid,
                                                       const unsigned int seed)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  const unsigned int n_contacts = n_bodies * contacts_per_pair;
  softgrain::contact::BlockDelassus W(n_contacts, n_components);
  for (unsigned int b = 0; b < n_bodies; ++b)
  {
    std::vector<unsigned int> rows;
    for (const unsigned int pair : {b, (b + 1) % n_bodies})
      for (unsigned int k = 0; k < contacts_per_pair * n_components; ++k)
        rows.push_back(pair * contacts_per_pair * n_components + k);
    const unsigned int size = rows.size();
    Eigen::MatrixXd H(size, size), R(size, 2);
    for (unsigned int i = 0; i < size; ++i)
      for (unsigned int j = 0; j < size; ++j)
        H(i, j) = normal(generator) / std::sqrt(double(size)) + (i == j ? 0.5 : 0.);
    for (unsigned int i = 0; i < size; ++i)
      for (unsigned int j = 0; j < 2; ++j)
        R(i, j) = normal(generator);
    W.add_block(rows, H * H.transpose() + rigid * R * R.transpose());
  }
  return W;
}

/// Largest difference between two vectors of one size.
inline double largest_difference(const std::vector<double> &a, const std::vector<double> &b)
{
  double worst = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
    worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

inline const char *verdict(const bool fine)
{
  return fine ? "yes" : "NO";
}

#endif
