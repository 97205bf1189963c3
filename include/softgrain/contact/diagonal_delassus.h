// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_diagonal_delassus_h
#define softgrain_contact_diagonal_delassus_h

#include <Eigen/SparseCore>

#include <vector>

namespace softgrain::contact
{
/**
 * @brief W when no impulse of one contact moves another: independent n_components x n_components blocks.
 *
 * The lumped nodal contact of two bodies is of this kind; every contact is then solved once and exactly.
 *
 * All operators share the interface below, which the solvers use inline: `begin()` sets the state to given
 * impulses, `velocity()` is the part W P of a contact's relative velocity, `apply()` tells the operator that
 * an impulse has changed, `diagonal_block()` is W_ii.
 */
class DiagonalDelassus
{
public:
  DiagonalDelassus() = default;

  /**
   * @param n_components components of a contact: 1, 2 or 3
   * @param blocks the symmetric blocks one after the other (1/kg, in the plane m/kg), row by row,
   * n_components^2 each
   * @throw InputError when the number of values does not fit, ComputationError when a value is not finite.
   */
  DiagonalDelassus(unsigned int n_components, std::vector<double> blocks);

  unsigned int n_components() const { return components; }
  unsigned int n_contacts() const { return impulse.size() / components; }

  /// Sets the impulses (N s per metre), n_contacts * n_components values.
  void begin(const std::vector<double> &impulses);

  /// Writes W P of @p contact to @p w; n must be n_components().
  template <unsigned int n>
  void velocity(const unsigned int contact, double (&w)[n]) const
  {
    const double *block = values.data() + contact * n * n;
    const double *p = impulse.data() + contact * n;
    for (unsigned int c = 0; c < n; ++c)
    {
      w[c] = 0.;
      for (unsigned int d = 0; d < n; ++d)
        w[c] += block[c * n + d] * p[d];
    }
  }

  /// Adds @p change to the impulse of @p contact.
  template <unsigned int n>
  void apply(const unsigned int contact, const double (&change)[n])
  {
    for (unsigned int c = 0; c < n; ++c)
      impulse[contact * n + c] += change[c];
  }

  /// Writes W_ii of @p contact to @p block, n_components^2 values.
  void diagonal_block(unsigned int contact, double *block) const;

  /// W as one sparse matrix, for solvers that factorise and for files.
  Eigen::SparseMatrix<double, Eigen::RowMajor> assemble() const;

private:
  unsigned int components = 1;
  std::vector<double> values;
  std::vector<double> impulse;
};
} // namespace softgrain::contact

#endif
