// SPDX-License-Identifier: LGPL-2.1-or-later
// The forces of rays in the plane for given sides of their conditions.
#include <softgrain/mpm/contact/frame_system.h>

#include <Eigen/SparseCholesky>
#include <unsupported/Eigen/IterativeSolvers>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
using Matrix = Eigen::SparseMatrix<double>;
using Factor = Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>>;

/// A factor as Eigen's iterative solvers want their preconditioner, of a matrix whose rows and columns have
/// been given other units.
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
  Eigen::VectorXd solve(const Eigen::VectorXd &b) const
  {
    return factor->solve(b.cwiseQuotient(*of_rows)).cwiseQuotient(*of_columns);
  }
  Eigen::ComputationInfo info() { return Eigen::Success; }

  const Factor *factor = nullptr;
  const Eigen::VectorXd *of_rows = nullptr, *of_columns = nullptr; ///< what the matrix was multiplied by
};
} // namespace

/// In the plane every solve tells it.
template <>
bool FrameSystem<2>::find_inertia()
{
  return true;
}

/// By single entries: contacts in the plane have few columns each.
template <>
bool FrameSystem<2>::solve_active()
{
  const int n = number_unknowns();
  std::vector<Eigen::Triplet<double>> entries, by_slip;
  for (const auto &entry : own)
  {
    const int row = number[entry.row()], column = number[entry.col()];
    if (row >= 0 && column >= 0)
      entries.emplace_back(std::max(row, column), std::min(row, column), entry.value());
    // What slips gives to walls under loads.
    if (const unsigned int i = entry.row(); column >= 0 && slips_with_force(i))
      by_slip.emplace_back(column, number[columns[i].mate], slips(i) * columns[i].bound * entry.value());
  }
  for (unsigned int b = 0; b < of_body.size(); ++b)
    for (unsigned int j = 0; j < of_body[b].size(); ++j)
    {
      const unsigned int here = of_body[b][j];
      if (number[here] >= 0)
        for (unsigned int i = j; i < of_body[b].size(); ++i)
          if (const int row = number[of_body[b][i]]; row >= 0)
            entries.emplace_back(std::max(row, number[here]), std::min(row, number[here]), W[b](i, j));
      if (slips_with_force(here))
        for (unsigned int i = 0; i < of_body[b].size(); ++i)
          if (const int row = number[of_body[b][i]]; row >= 0)
            by_slip.emplace_back(row, number[columns[here].mate],
                                 slips(here) * columns[here].bound * W[b](std::max(i, j), std::min(i, j)));
    }
  Matrix N(n, n);
  N.setFromTriplets(entries.begin(), entries.end());
  Factor of_N(N);
  if (of_N.info() != Eigen::Success)
    return false;
  negative = (of_N.vectorD().array() < 0.).count();
  knows_inertia = true;
  const Eigen::VectorXd b = right_of_unknowns(n);
  Eigen::VectorXd x;
  if (by_slip.empty())
  {
    x = of_N.solve(b);
    x += of_N.solve(Eigen::VectorXd(b - N.selfadjointView<Eigen::Lower>() * x));
  }
  else
  {
    Matrix full = N.selfadjointView<Eigen::Lower>(), slipping_part(n, n);
    slipping_part.setFromTriplets(by_slip.begin(), by_slip.end());
    full += slipping_part;
    // GMRES adds up squares: all equations become those of ways, and all unknowns too.
    const auto [of_rows, of_columns] = units_of_unknowns(n);
    full = of_rows.asDiagonal() * full * of_columns.asDiagonal();
    Eigen::GMRES<Matrix, ByFactor> gmres;
    gmres.preconditioner().factor = &of_N;
    gmres.preconditioner().of_rows = &of_rows;
    gmres.preconditioner().of_columns = &of_columns;
    gmres.compute(full);
    gmres.setTolerance(gmres_tolerance);
    gmres.set_restart(gmres_restart);
    gmres.setMaxIterations(gmres_iterations);
    x = of_columns.cwiseProduct(gmres.solve(of_rows.cwiseProduct(b)));
    if (gmres.info() != Eigen::Success)
      return false;
  }
  return take_unknowns(x);
}
} // namespace softgrain::mpm
