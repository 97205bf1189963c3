// SPDX-License-Identifier: LGPL-2.1-or-later
// The forces of rays for given columns: which are closed, which stick and which slip.
#include <softgrain/mpm/contact/frame_system.h>

#include <unsupported/Eigen/IterativeSolvers>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
constexpr unsigned int most_passes = 40;
constexpr unsigned int most_in_saddle = 3; ///< passes in which a set may belong to no minimum
constexpr unsigned int one_by_one = 15;    ///< passes after which only the worst ray changes sides

using Matrix = Eigen::SparseMatrix<double>;
using Factor = Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>>;

/// A factor as Eigen's iterative solvers want their preconditioner.
class ByFactor
{
public:
  ByFactor() = default;
  template <class M>
  ByFactor &analyzePattern(const M &)
  {
    return *this;
  }
  template <class M>
  ByFactor &factorize(const M &)
  {
    return *this;
  }
  template <class M>
  ByFactor &compute(const M &)
  {
    return *this;
  }
  Eigen::VectorXd solve(const Eigen::VectorXd &b) const { return factor->solve(b); }
  Eigen::ComputationInfo info() { return Eigen::Success; }

  const Factor *factor = nullptr;
};
} // namespace

bool FrameSystem::solve_active(const Eigen::VectorXd &right)
{
  std::vector<int> number(columns.size(), -1);
  int n = 0;
  for (const unsigned int i : order)
    if (counts(i))
      number[i] = n++;
  std::vector<Eigen::Triplet<double>> entries, by_slip;
  for (const auto &entry : own)
    if (number[entry.row()] >= 0 && number[entry.col()] >= 0)
    {
      const int row = number[entry.row()], column = number[entry.col()];
      entries.emplace_back(std::max(row, column), std::min(row, column), entry.value());
    }
  for (unsigned int b = 0; b < of_body.size(); ++b)
    for (unsigned int j = 0; j < of_body[b].size(); ++j)
    {
      const unsigned int here = of_body[b][j];
      if (number[here] >= 0)
        for (unsigned int i = j; i < of_body[b].size(); ++i)
          if (const int row = number[of_body[b][i]]; row >= 0)
            entries.emplace_back(std::max(row, number[here]), std::min(row, number[here]), W[b](i, j));
      if (active[here] && slips(here) != 0)
        for (unsigned int i = 0; i < of_body[b].size(); ++i)
          if (const int row = number[of_body[b][i]]; row >= 0)
            by_slip.emplace_back(row, number[columns[here].mate],
                                 slips(here) * columns[here].bound * W[b](std::max(i, j), std::min(i, j)));
    }
  Matrix N(n, n);
  N.setFromTriplets(entries.begin(), entries.end());
  Factor factor(N);
  if (factor.info() != Eigen::Success)
    return false;
  negative = (factor.vectorD().array() < 0.).count();
  Eigen::VectorXd b(n), x;
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (number[i] >= 0)
      b[number[i]] = right[i];
  if (by_slip.empty())
  {
    x = factor.solve(b);
    x += factor.solve(Eigen::VectorXd(b - N.selfadjointView<Eigen::Lower>() * x));
  }
  else
  {
    Matrix full = N.selfadjointView<Eigen::Lower>(), slipping_part(n, n);
    slipping_part.setFromTriplets(by_slip.begin(), by_slip.end());
    full += slipping_part;
    Eigen::GMRES<Matrix, ByFactor> gmres;
    gmres.preconditioner().factor = &factor;
    gmres.compute(full);
    gmres.setTolerance(1e-12);
    gmres.set_restart(60);
    gmres.setMaxIterations(200);
    x = gmres.solve(b);
    if (gmres.info() != Eigen::Success)
      return false;
  }
  if (!x.allFinite())
    return false;
  z.setZero();
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (number[i] >= 0)
      z[i] = x[number[i]];
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (active[i] && slips(i) != 0)
      z[i] = slips(i) * columns[i].bound * z[columns[i].mate];
  return true;
}

Eigen::VectorXd FrameSystem::beyond(const Eigen::VectorXd &right) const
{
  Eigen::VectorXd here = -right;
  for (unsigned int b = 0; b < of_body.size(); ++b)
    if (!of_body[b].empty())
    {
      const Eigen::VectorXd effect = W[b] * z_of(b);
      for (unsigned int i = 0; i < of_body[b].size(); ++i)
        here[of_body[b][i]] += effect[i];
    }
  for (const auto &entry : own)
  {
    here[entry.col()] += entry.value() * z[entry.row()];
    if (entry.row() != entry.col())
      here[entry.row()] += entry.value() * z[entry.col()];
  }
  return here;
}

bool FrameSystem::change_sides(const Eigen::VectorXd &here, const double cell_size, const bool all)
{
  const double largest = z.size() > 0 ? z.cwiseAbs().maxCoeff() : 0.;
  int worst = -1;
  double most = 0.;
  bool settled = true;
  // Rays that are where they must not be, and by how much.
  const auto change = [&](const unsigned int i, const double amount, const auto &to_other_side)
  {
    settled = false;
    if (all)
      to_other_side();
    else if (amount > most)
    {
      most = amount;
      worst = i;
    }
  };
  const auto flip = [&](const unsigned int i)
  {
    signed char &slip = slipping[columns[i].frame][columns[i].ray_number];
    if (columns[i].kind == Column::slide)
      slip = slip != 0 ? 0 : z[i] > 0. ? 1 : -1;
    else
    {
      active[i] = !active[i];
      if (columns[i].mate != Column::none)
        active[columns[i].mate] = active[i];
    }
  };
  for (unsigned int i = 0; i < columns.size(); ++i)
  {
    if (columns[i].kind == Column::ray)
    {
      const double wrong = active[i] ? -z[i] / largest : -here[i] / cell_size;
      if (wrong > (active[i] ? 1e-12 : 1e-10))
        change(i, wrong, [&]() { flip(i); });
    }
    else if (columns[i].kind == Column::slide && active[i])
    {
      const double wrong = slips(i) == 0
                               ? (std::abs(z[i]) - columns[i].bound * std::max(0., z[columns[i].mate])) / largest
                               : slips(i) * here[i] / cell_size;
      if (wrong > 1e-10)
        change(i, wrong, [&]() { flip(i); });
    }
  }
  if (worst >= 0)
    flip(worst);
  return settled;
}

bool FrameSystem::solve(const std::vector<Eigen::VectorXd> &way_without,
                        const double cell_size,
                        const unsigned int negative_of_bodies)
{
  Eigen::VectorXd right = -Eigen::Map<const Eigen::VectorXd>(gap.data(), gap.size());
  for (unsigned int b = 0; b < of_body.size(); ++b)
    if (!of_body[b].empty())
    {
      const Eigen::VectorXd moved = V[b].transpose() * way_without[b];
      for (unsigned int i = 0; i < of_body[b].size(); ++i)
        right[of_body[b][i]] -= moved[i];
    }
  bool settled = false;
  for (unsigned int pass = 0; pass < most_passes && !settled; ++pass)
  {
    ++passes;
    if (!solve_active(right) || (pass >= most_in_saddle && wrong_inertia(negative_of_bodies) != 0))
      return false;
    settled = change_sides(beyond(right), cell_size, pass < one_by_one);
  }
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (columns[i].kind == Column::ray)
      found[columns[i].frame][columns[i].ray_number] = std::max(0., z[i]);
    else if (columns[i].kind == Column::slide && active[i])
      found_rubbing[columns[i].frame][columns[i].ray_number] = z[i];
  return settled;
}
} // namespace softgrain::mpm
