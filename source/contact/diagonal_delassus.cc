// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/contact/diagonal_delassus.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace softgrain::contact
{
DiagonalDelassus::DiagonalDelassus(const unsigned int n_components, std::vector<double> blocks)
    : components(n_components), values(std::move(blocks))
{
  if (components < 1 || components > 3)
    throw InputError("a contact has 1, 2 or 3 components, not " + std::to_string(components));
  if (values.size() % (components * components) != 0)
    throw InputError("diagonal Delassus operator: " + std::to_string(values.size()) +
                     " values do not make whole blocks of " + std::to_string(components * components));
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw ComputationError("diagonal Delassus operator: block " +
                             std::to_string(i / (components * components)) + " is not finite");
  impulse.assign(values.size() / components, 0.);
}

void DiagonalDelassus::begin(const std::vector<double> &impulses)
{
  if (impulses.size() != impulse.size())
    throw InputError("Delassus operator: " + std::to_string(impulses.size()) + " impulses, " +
                     std::to_string(impulse.size()) + " expected");
  impulse = impulses;
}

void DiagonalDelassus::diagonal_block(const unsigned int contact, double *block) const
{
  std::copy_n(values.data() + contact * components * components, components * components, block);
}

Eigen::SparseMatrix<double, Eigen::RowMajor> DiagonalDelassus::assemble() const
{
  Eigen::SparseMatrix<double, Eigen::RowMajor> W(impulse.size(), impulse.size());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const unsigned int contact = i / (components * components), entry = i % (components * components);
    entries.emplace_back(contact * components + entry / components, contact * components + entry % components,
                         values[i]);
  }
  W.setFromTriplets(entries.begin(), entries.end());
  return W;
}
} // namespace softgrain::contact
