// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/contact/mass_delassus.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace softgrain::contact
{
MassDelassus::MassDelassus(const unsigned int n_components,
                           std::vector<unsigned int> row_start,
                           std::vector<unsigned int> dofs,
                           std::vector<double> weights,
                           std::vector<double> inverse_masses)
    : components(n_components)
    , start(std::move(row_start))
    , dof(std::move(dofs))
    , weight(std::move(weights))
    , inverse_mass(std::move(inverse_masses))
{
  const std::string name = "mass Delassus operator: ";
  if (components < 1 || components > 3)
    throw InputError("a contact has 1, 2 or 3 components, not " + std::to_string(components));
  if (start.empty())
    start.push_back(0);
  if ((start.size() - 1) % components != 0)
    throw InputError(name + std::to_string(start.size() - 1) + " rows do not make whole contacts of " +
                     std::to_string(components) + " components");
  if (start.front() != 0 || start.back() != dof.size() || weight.size() != dof.size() ||
      !std::is_sorted(start.begin(), start.end()))
    throw InputError(name + "row offsets, degrees of freedom and weights do not fit together");
  for (std::size_t e = 0; e < dof.size(); ++e)
  {
    if (dof[e] >= inverse_mass.size())
      throw InputError(name + "degree of freedom " + std::to_string(dof[e]) + " has no mass");
    if (!std::isfinite(weight[e]))
      throw ComputationError(name + "a weight of degree of freedom " + std::to_string(dof[e]) +
                             " is not finite");
  }
  for (std::size_t i = 0; i < inverse_mass.size(); ++i)
  {
    if (!std::isfinite(inverse_mass[i]))
      throw ComputationError(name + "the inverse mass of degree of freedom " + std::to_string(i) +
                             " is not finite");
    if (inverse_mass[i] < 0.)
      throw InputError(name + "the inverse mass of degree of freedom " + std::to_string(i) + " is negative");
  }
  weight_per_mass.resize(weight.size());
  for (std::size_t e = 0; e < dof.size(); ++e)
    weight_per_mass[e] = weight[e] * inverse_mass[dof[e]];
  dof_velocity.assign(inverse_mass.size(), 0.);
}

void MassDelassus::begin(const std::vector<double> &impulses)
{
  if (impulses.size() + 1 != std::max<std::size_t>(start.size(), 1))
    throw InputError("Delassus operator: " + std::to_string(impulses.size()) + " impulses, " +
                     std::to_string(n_contacts() * components) + " expected");
  std::fill(dof_velocity.begin(), dof_velocity.end(), 0.);
  for (std::size_t row = 0; row < impulses.size(); ++row)
    if (impulses[row] != 0.)
      for (unsigned int e = start[row]; e < start[row + 1]; ++e)
        dof_velocity[dof[e]] += weight_per_mass[e] * impulses[row];
}

void MassDelassus::diagonal_block(const unsigned int contact, double *block) const
{
  // Rows are short, so comparing all pairs is cheaper than keeping them sorted; a dof may be in a row twice.
  for (unsigned int c = 0; c < components; ++c)
    for (unsigned int d = 0; d < components; ++d)
    {
      double sum = 0.;
      const std::size_t row = contact * components + c, column = contact * components + d;
      for (unsigned int e = start[row]; e < start[row + 1]; ++e)
        for (unsigned int f = start[column]; f < start[column + 1]; ++f)
          if (dof[e] == dof[f])
            sum += weight_per_mass[e] * weight[f];
      block[c * components + d] = sum;
    }
}

Eigen::SparseMatrix<double, Eigen::RowMajor> MassDelassus::assemble() const
{
  const std::size_t n = start.empty() ? 0 : start.size() - 1;
  std::vector<Eigen::Triplet<double>> entries, scaled;
  for (std::size_t row = 0; row < n; ++row)
    for (unsigned int e = start[row]; e < start[row + 1]; ++e)
    {
      entries.emplace_back(row, dof[e], weight[e]);
      scaled.emplace_back(row, dof[e], weight_per_mass[e]);
    }
  Eigen::SparseMatrix<double, Eigen::RowMajor> H(n, inverse_mass.size()), S(n, inverse_mass.size());
  H.setFromTriplets(entries.begin(), entries.end());
  S.setFromTriplets(scaled.begin(), scaled.end());
  return H * Eigen::SparseMatrix<double, Eigen::RowMajor>(S.transpose());
}
} // namespace softgrain::contact
