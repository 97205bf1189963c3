// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/one_sided_forces.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <set>

namespace softgrain::mpm
{
namespace
{
constexpr unsigned int most_passes = 60;
/// After sets have repeated only places change sides that are wrong by that share of the worst.
constexpr double share_of_worst = 0.5;
} // namespace

Eigen::MatrixXd OneSidedForces::closed_part(std::vector<unsigned int> &places) const
{
  places.clear();
  for (unsigned int k = 0; k < closed.size(); ++k)
    if (closed[k])
      places.push_back(k);
  Eigen::MatrixXd part(places.size(), places.size());
  for (unsigned int i = 0; i < places.size(); ++i)
    for (unsigned int j = 0; j < places.size(); ++j)
      part(i, j) = compliance(places[i], places[j]);
  return part;
}

bool OneSidedForces::solve(const double tolerance)
{
  const unsigned int n = gap.size();
  force.setZero(n);
  std::set<std::vector<char>> seen{closed};
  bool repeats = false;
  std::vector<unsigned int> places;
  for (passes = 1; passes <= most_passes; ++passes)
  {
    const Eigen::MatrixXd part = closed_part(places);
    Eigen::VectorXd right(places.size());
    for (unsigned int i = 0; i < places.size(); ++i)
      right[i] = -gap[places[i]];
    const Eigen::VectorXd found = part.partialPivLu().solve(right);
    if (!found.allFinite())
      return false;
    force.setZero(n);
    for (unsigned int i = 0; i < places.size(); ++i)
      force[places[i]] = found[i];
    const Eigen::VectorXd now = gap + compliance * force;
    Eigen::VectorXd wrong = Eigen::VectorXd::Zero(n);
    for (unsigned int k = 0; k < n; ++k)
      if (const double by = closed[k] ? -force[k] * std::abs(compliance(k, k)) : -now[k]; by > tolerance)
        wrong[k] = by;
    const double worst = n > 0 ? wrong.maxCoeff() : 0.;
    if (worst == 0.)
    {
      force = force.cwiseMax(0.);
      return true;
    }
    for (unsigned int k = 0; k < n; ++k)
      if (wrong[k] > 0. && wrong[k] >= (repeats ? share_of_worst * worst : 0.))
        closed[k] = !closed[k];
    repeats = repeats || !seen.insert(closed).second;
  }
  return false;
}

unsigned int OneSidedForces::n_negative() const
{
  std::vector<unsigned int> places;
  const Eigen::MatrixXd part = closed_part(places);
  if (places.empty())
    return 0;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(part, Eigen::EigenvaluesOnly);
  return (solver.eigenvalues().array() < 0.).count();
}
} // namespace softgrain::mpm
