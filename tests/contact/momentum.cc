// SPDX-License-Identifier: LGPL-2.1-or-later
// Sweeps with momentum: the answer of plain sweeps in a fraction of them, for every operator, with and
// without friction; and where momentum alone would swing without end, the best impulses are those returned.
#include "reference.h"

#include <softgrain/contact/gauss_seidel.h>
#include <softgrain/contact/mass_delassus.h>

#include <algorithm>
#include <iostream>

using namespace softgrain::contact;

namespace
{
struct Solution
{
  SolverReport report;
  std::vector<double> impulses, velocities;
};

template <class Operator>
Solution sweep(Operator &W,
               const Problem &problem,
               const Algorithm algorithm,
               const unsigned int limit,
               const double tolerance)
{
  SolverSettings settings;
  settings.algorithm = algorithm;
  settings.max_sweeps = limit;
  settings.tolerance = tolerance;
  Solution result;
  result.report = gauss_seidel(W, problem, settings, result.impulses, result.velocities);
  return result;
}

template <class Operator>
void compare(const std::string &title, Operator &W, const Problem &problem, const double factor)
{
  const Solution plain = sweep(W, problem, Algorithm::gauss_seidel, 200000, 1e-9),
                 fast = sweep(W, problem, Algorithm::accelerated, 200000, 1e-9);
  std::cout << title << ": both converged " << verdict(plain.report.converged && fast.report.converged)
            << ", same velocities to 1e-7 "
            << verdict(largest_difference(plain.velocities, fast.velocities) < 1e-7) << ", sweeps below 1/"
            << factor << ' ' << verdict(factor * fast.report.sweeps < plain.report.sweeps)
            << ", without giving up " << verdict(!fast.report.fell_back) << '\n';
  std::cerr << title << ": " << plain.report.sweeps << " plain, " << fast.report.sweeps << " with momentum\n";
}

/// Masses 1 on top of each other on the floor, which fall on it with speed 1: sweeps carry news one mass far.
MassDelassus column(const unsigned int n, std::vector<double> &q)
{
  std::vector<unsigned int> start{0, 1}, dofs{0};
  std::vector<double> weights{1.};
  for (unsigned int i = 1; i < n; ++i)
  {
    dofs.insert(dofs.end(), {i - 1, i}); // from above, so that a sweep upwards is no direct solution
    weights.insert(weights.end(), {-1., 1.});
    start.push_back(dofs.size());
  }
  q.assign(n, 0.);
  q[0] = -1.;
  return MassDelassus(1, start, dofs, weights, std::vector<double>(n, 1.));
}

/// Square bodies in @p m columns of @p m on a floor, four contacts with each neighbour; n components. A push
/// dents a body nearby, exp(-|i - j| / 3), and moves it as a whole, 200 times as far.
BlockDelassus pile(const unsigned int m, const unsigned int n)
{
  const unsigned int k = 4;
  // Sides in the order below, above (normals along y), left, right (along x); contacts of horizontal sides
  // first.
  const auto side = [&](const unsigned int x, const unsigned int y, const unsigned int s) -> int
  {
    if (s < 2)
      return y + s < m ? int((x * m + y + s) * k) : -1;
    const int left = int(x) - 1 + int(s - 2);
    return left >= 0 && left + 1 < int(m) ? int((m * m + left * m + y) * k) : -1;
  };
  BlockDelassus W((m * m + (m - 1) * m) * k, n);
  for (unsigned int x = 0; x < m; ++x)
    for (unsigned int y = 0; y < m; ++y)
    {
      std::vector<unsigned int> rows, sides, axes, places;
      std::vector<double> signs;
      for (unsigned int s = 0; s < 4; ++s)
        for (unsigned int i = 0; i < k && side(x, y, s) >= 0; ++i)
          for (unsigned int c = 0; c < n; ++c)
          {
            rows.push_back((side(x, y, s) + i) * n + c);
            sides.push_back(s);
            places.push_back(i);
            axes.push_back(c == 2 ? 2 : (s < 2 ? 1 - c : c));
            signs.push_back(s % 2 == 0 ? 1. : -1.);
          }
      Eigen::MatrixXd block(rows.size(), rows.size());
      for (unsigned int i = 0; i < rows.size(); ++i)
        for (unsigned int j = 0; j < rows.size(); ++j)
        {
          const bool same = axes[i] == axes[j];
          block(i, j) = same ? 200. * signs[i] * signs[j] : 0.;
          if (same && sides[i] == sides[j])
            block(i, j) += std::exp(-std::abs(double(places[i]) - double(places[j])) / 3.);
        }
      W.add_block(rows, block);
    }
  return W;
}

/// Bodies in a ring, eight contacts with each neighbour and the same compliance: without going both ways,
/// momentum circles here for ever.
BlockDelassus ring(const unsigned int n_bodies)
{
  const unsigned int k = 8;
  BlockDelassus W(n_bodies * k, 1);
  for (unsigned int b = 0; b < n_bodies; ++b)
  {
    std::vector<unsigned int> rows;
    Eigen::MatrixXd block(2 * k, 2 * k);
    for (unsigned int i = 0; i < 2 * k; ++i)
    {
      rows.push_back((i < k ? b : (b + 1) % n_bodies) * k + i % k);
      for (unsigned int j = 0; j < 2 * k; ++j)
      {
        const bool same_side = (i < k) == (j < k);
        block(i, j) = same_side ? 10. + std::exp(-std::abs(double(i) - double(j)) / 3.) : -10.;
      }
    }
    W.add_block(rows, block);
  }
  return W;
}

Problem random_problem(const unsigned int n_contacts)
{
  Problem problem{1, {}, {}};
  std::mt19937 generator(7);
  std::normal_distribution<double> normal;
  for (unsigned int i = 0; i < n_contacts; ++i)
    problem.free_velocity.push_back(normal(generator) - 1.);
  return problem;
}

/// The pile falls on its floor with speed 1, and everything moves a little besides.
Problem falling(const unsigned int m, const unsigned int n)
{
  const unsigned int n_contacts = (m * m + (m - 1) * m) * 4;
  Problem problem{n, {}, {}};
  if (n > 1)
    problem.friction.assign(n_contacts, 0.3);
  std::mt19937 generator(7);
  std::normal_distribution<double> normal;
  for (unsigned int i = 0; i < n_contacts; ++i)
    for (unsigned int c = 0; c < n; ++c)
      problem.free_velocity.push_back(0.1 * normal(generator) -
                                      (c == 0 && i / 4 % m == 0 && i < 4 * m * m ? 1. : 0.));
  return problem;
}
} // namespace

int main()
{
  {
    std::vector<double> q;
    MassDelassus W = column(60, q);
    const Problem problem{1, q, {}};
    compare("column of 60 masses", W, problem, 10.);
    // Every mass stops: contact i carries the momentum of the 60 - i masses from it upwards.
    const Solution fast = sweep(W, problem, Algorithm::accelerated, 20000, 1e-10);
    double error = 0.;
    for (unsigned int i = 0; i < 60; ++i)
      error = std::max(error, std::abs(fast.impulses[i] - (60. - i)));
    std::cout << "  impulses are the momentum above, to 1e-6 " << verdict(error < 1e-6) << '\n';
  }
  for (const unsigned int n : {1, 2, 3})
  {
    BlockDelassus W = pile(10, n);
    compare("pile of 100 bodies, components " + std::to_string(n), W, falling(10, n), 3.);
  }
  {
    BlockDelassus W = ring(40);
    compare("ring of 40 bodies", W, random_problem(W.n_contacts()), 0.5);
  }
  // Cut off anywhere, the impulses returned are no worse than those of a check before (every fifth sweep).
  BlockDelassus W = pile(10, 1);
  const Problem problem = falling(10, 1);
  double lowest = 1e300;
  bool monotone = true, consistent = true;
  for (unsigned int limit = 5; limit <= 300; limit += 5)
  {
    const Solution cut = sweep(W, problem, Algorithm::accelerated, limit, 1e-12);
    monotone = monotone && cut.report.residual <= lowest;
    lowest = std::min(lowest, cut.report.residual);
    std::vector<double> velocities;
    compute_velocities(W, problem, cut.impulses, velocities);
    consistent = consistent && largest_difference(velocities, cut.velocities) < 1e-9;
  }
  std::cout << "cut off after 5, 10, ... sweeps: never worse " << verdict(monotone)
            << ", velocities are those of the impulses " << verdict(consistent) << '\n';
  const Solution odd = sweep(W, problem, Algorithm::accelerated, 7, 1e-12);
  std::cout << "limit of 7 sweeps: " << odd.report.sweeps << '\n';
}
