// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/anderson_mixing.h>

#include <Eigen/Cholesky>

namespace softgrain::mpm
{
namespace
{
Eigen::VectorXd joined(const std::vector<Eigen::VectorXd> &parts)
{
  Eigen::Index size = 0;
  for (const Eigen::VectorXd &part : parts)
    size += part.size();
  Eigen::VectorXd all(size);
  size = 0;
  for (const Eigen::VectorXd &part : parts)
  {
    all.segment(size, part.size()) = part;
    size += part.size();
  }
  return all;
}
} // namespace

void AndersonMixing::restart()
{
  last_change.resize(0);
  change_differences.clear();
  g_differences.clear();
}

Eigen::VectorXd AndersonMixing::next(const Eigen::VectorXd &x, const Eigen::VectorXd &g)
{
  const Eigen::VectorXd change = g - x;
  if (last_change.size() == change.size())
  {
    change_differences.push_back(change - last_change);
    g_differences.push_back(g - last_g);
    if (change_differences.size() > depth)
    {
      change_differences.pop_front();
      g_differences.pop_front();
    }
  }
  last_change = change;
  last_g = g;
  const Eigen::Index n = change_differences.size();
  if (n == 0)
    return g;
  // The normal equations will do: few columns, and what is nearly dependent is damped.
  Eigen::MatrixXd square(n, n);
  Eigen::VectorXd right(n);
  for (Eigen::Index i = 0; i < n; ++i)
  {
    right[i] = change_differences[i].dot(change);
    for (Eigen::Index j = 0; j <= i; ++j)
      square(i, j) = square(j, i) = change_differences[i].dot(change_differences[j]);
  }
  const double trace = square.trace();
  if (!(trace > 0.))
    return g;
  square.diagonal().array() += 1e-10 * trace;
  const Eigen::VectorXd share = square.ldlt().solve(right);
  Eigen::VectorXd mixed = g;
  for (Eigen::Index i = 0; i < n; ++i)
    mixed -= share[i] * g_differences[i];
  return mixed;
}

std::vector<Eigen::VectorXd> AndersonMixing::next(const std::vector<Eigen::VectorXd> &x,
                                                  const std::vector<Eigen::VectorXd> &g)
{
  const Eigen::VectorXd all = next(joined(x), joined(g));
  std::vector<Eigen::VectorXd> mixed;
  Eigen::Index at = 0;
  for (const Eigen::VectorXd &part : g)
  {
    mixed.push_back(all.segment(at, part.size()));
    at += part.size();
  }
  return mixed;
}
} // namespace softgrain::mpm
