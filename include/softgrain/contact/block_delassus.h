// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_block_delassus_h
#define softgrain_contact_block_delassus_h

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace softgrain::contact
{
/**
 * @brief W as a sum over bodies of dense symmetric blocks, W = Σ_b E_b W_b E_bᵀ with W_b = H_b A_b⁻¹ H_bᵀ.
 *
 * E_b places the rows of body b among the components of all contacts. Every block keeps its own copy of the
 * impulses on its rows, so that the velocity of a contact is one contiguous dot product per block that holds
 * it (any number, two for a pair of bodies). Interface as explained for DiagonalDelassus.
 */
class BlockDelassus
{
public:
  BlockDelassus() = default;
  BlockDelassus(unsigned int n_contacts, unsigned int n_components) { reinit(n_contacts, n_components); }

  /// Forgets all blocks, keeps the memory. @throw InputError unless n_components is 1, 2 or 3.
  void reinit(unsigned int n_contacts, unsigned int n_components);

  /**
   * @brief Adds the block of one body.
   * @param components contact * n_components + component of each row of @p block, no row twice
   * @param block dense symmetric positive semi-definite matrix (1/kg, in the plane m/kg)
   * @throw InputError when sizes, indices or the symmetry are wrong.
   * @throw ComputationError when a value is not finite.
   */
  void add_block(const std::vector<unsigned int> &components, const Eigen::Ref<const Eigen::MatrixXd> &block);

  /// Adds a block without its matrix, which set_block() gives or somebody writes to block_values().
  void add_room(const std::vector<unsigned int> &components);
  /// Sets the matrix of block @p b; blocks may get theirs at the same time. @throw as add_block()
  void set_block(unsigned int b, const Eigen::Ref<const Eigen::MatrixXd> &block);
  /// Numbers of block @p b, row by row, until the next one is added.
  double *block_values(const unsigned int b) { return values.data() + blocks[b].value; }

  unsigned int n_components() const { return components; }
  unsigned int n_contacts() const { return contacts; }
  unsigned int n_blocks() const { return blocks.size(); }

  /// Component indices of the rows of block @p b, as given to add_block().
  std::vector<unsigned int> block_components(unsigned int b) const;

  /// The matrix of block @p b.
  Eigen::MatrixXd block(unsigned int b) const;

  /// Sets the impulses (N s per metre), n_contacts * n_components values, and orders the rows after new
  /// blocks.
  void begin(const std::vector<double> &impulses);

  /// Writes W P of @p contact to @p w; n must be n_components().
  template <unsigned int n>
  void velocity(const unsigned int contact, double (&w)[n]) const
  {
    for (unsigned int c = 0; c < n; ++c)
    {
      w[c] = 0.;
      for (unsigned int e = row_start[contact * n + c]; e < row_start[contact * n + c + 1]; ++e)
      {
        using Row = Eigen::Map<const Eigen::VectorXd>;
        w[c] += Row(values.data() + rows[e].value, rows[e].size)
                    .dot(Row(impulse.data() + rows[e].impulse, rows[e].size));
      }
    }
  }

  /// Adds @p change to the impulse of @p contact.
  template <unsigned int n>
  void apply(const unsigned int contact, const double (&change)[n])
  {
    for (unsigned int c = 0; c < n; ++c)
      for (unsigned int e = row_start[contact * n + c]; e < row_start[contact * n + c + 1]; ++e)
        impulse[rows[e].impulse + rows[e].local] += change[c];
  }

  /// Writes W_ii of @p contact to @p block, n_components^2 values. Call begin() first.
  void diagonal_block(unsigned int contact, double *block) const;

  /// W as one sparse matrix, for solvers that factorise.
  Eigen::SparseMatrix<double, Eigen::RowMajor> assemble() const;

private:
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  struct Block
  {
    unsigned int size;
    std::size_t value; // of its first row in values
    std::size_t row;   // of its first row in row_component and in impulse
  };

  /// One component's row in one block.
  struct Row
  {
    std::size_t value;   // start in values
    std::size_t impulse; // start of the block in impulse
    unsigned int size;
    unsigned int local;
  };

  void order_rows();
  Eigen::Map<Matrix> place(unsigned int b);

  unsigned int contacts = 0;
  unsigned int components = 1;
  bool ordered = false;
  std::vector<Block> blocks;
  std::vector<unsigned int> row_component;
  std::vector<double> values;
  std::vector<double> impulse;
  std::vector<unsigned int> row_start;
  std::vector<Row> rows;
};
} // namespace softgrain::contact

#endif
