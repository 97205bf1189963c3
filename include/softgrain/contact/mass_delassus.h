// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_mass_delassus_h
#define softgrain_contact_mass_delassus_h

#include <Eigen/SparseCore>

#include <vector>

namespace softgrain::contact
{
/**
 * @brief W = H M⁻¹ Hᵀ with sparse rows H and a diagonal mass matrix; W itself is never formed.
 *
 * The velocities that the impulses give the degrees of freedom, v = M⁻¹ Hᵀ P, are kept up to date, so that a
 * contact costs its own entries of H whatever shares its nodes: explicit steps with several rows or three and
 * more bodies at a node, and rigid bodies. Interface as explained for DiagonalDelassus.
 */
class MassDelassus
{
public:
  MassDelassus() = default;

  /**
   * @param n_components components of a contact: 1, 2 or 3
   * @param row_start rows + 1 offsets into @p dofs and @p weights; row = contact * n_components + component
   * @param dofs degree of freedom of each entry of H
   * @param weights value of each entry of H (dimensionless)
   * @param inverse_mass per degree of freedom (1/kg, in the plane m/kg); 0 where the velocity is prescribed
   * @throw InputError when sizes or indices do not fit or a mass is negative.
   * @throw ComputationError when a value is not finite.
   */
  MassDelassus(unsigned int n_components,
               std::vector<unsigned int> row_start,
               std::vector<unsigned int> dofs,
               std::vector<double> weights,
               std::vector<double> inverse_mass);

  unsigned int n_components() const { return components; }
  unsigned int n_contacts() const { return start.empty() ? 0 : (start.size() - 1) / components; }

  /// Sets the impulses (N s per metre), n_contacts * n_components values.
  void begin(const std::vector<double> &impulses);

  /// Writes W P of @p contact to @p w; n must be n_components().
  template <unsigned int n>
  void velocity(const unsigned int contact, double (&w)[n]) const
  {
    for (unsigned int c = 0; c < n; ++c)
    {
      w[c] = 0.;
      for (unsigned int e = start[contact * n + c]; e < start[contact * n + c + 1]; ++e)
        w[c] += weight[e] * dof_velocity[dof[e]];
    }
  }

  /// Adds @p change to the impulse of @p contact: v += M⁻¹ Hᵀ change.
  template <unsigned int n>
  void apply(const unsigned int contact, const double (&change)[n])
  {
    for (unsigned int c = 0; c < n; ++c)
      for (unsigned int e = start[contact * n + c]; e < start[contact * n + c + 1]; ++e)
        dof_velocity[dof[e]] += weight_per_mass[e] * change[c];
  }

  /// Writes W_ii of @p contact to @p block, n_components^2 values.
  void diagonal_block(unsigned int contact, double *block) const;

  /// Velocity change M⁻¹ Hᵀ P of every degree of freedom (m/s), as of the last begin() and the applied
  /// changes.
  const std::vector<double> &velocities() const { return dof_velocity; }

  /// W as one sparse matrix, for solvers that factorise.
  Eigen::SparseMatrix<double, Eigen::RowMajor> assemble() const;

  const std::vector<unsigned int> &row_start() const { return start; }
  const std::vector<unsigned int> &dofs() const { return dof; }
  const std::vector<double> &weights() const { return weight; }
  const std::vector<double> &inverse_masses() const { return inverse_mass; }

private:
  unsigned int components = 1;
  std::vector<unsigned int> start;
  std::vector<unsigned int> dof;
  std::vector<double> weight;
  std::vector<double> weight_per_mass;
  std::vector<double> inverse_mass;
  std::vector<double> dof_velocity;
};
} // namespace softgrain::contact

#endif
