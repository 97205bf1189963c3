// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_linear_dense_kernels_h
#define softgrain_linear_dense_kernels_h

#include <cstddef>

namespace softgrain
{
/**
 * @brief Products of small dense matrices by columns, for those of the panels of a band, where the packing of
 * general kernels costs more than the product.
 *
 * Every matrix has a number of rows that is a multiple of `DenseKernels::rows`, and products one of columns
 * that is a multiple of `DenseKernels::columns`; callers fill up with zeros. A value is summed in the same
 * order wherever it stands.
 */
class DenseKernels
{
public:
#if defined(__AVX512F__)
  static constexpr int lanes = 8;
#elif defined(__AVX__)
  static constexpr int lanes = 4;
#else
  static constexpr int lanes = 2;
#endif
  static constexpr int rows = 8;    ///< of which the number of rows of a matrix is a multiple
  static constexpr int columns = 8; ///< of which the number of columns of a product is a multiple

  /// A vector register, at any address.
  using Lanes [[gnu::vector_size(8 * lanes), gnu::aligned(8), gnu::may_alias]] = double;

  static Lanes load(const double *const x)
  {
    return *reinterpret_cast<const Lanes *>(x);
  }
  static void store(double *const x, const Lanes &value)
  {
    *reinterpret_cast<Lanes *>(x) = value;
  }

  /// A matrix by columns that are @p stride apart.
  template <class Number>
  struct Matrix
  {
    Number *data;
    std::ptrdiff_t stride;
    Number *at(const std::ptrdiff_t row, const std::ptrdiff_t column) const
    {
      return data + row + column * stride;
    }
    /// The part from there on.
    Matrix from(const std::ptrdiff_t row, const std::ptrdiff_t column) const
    {
      return {at(row, column), stride};
    }
    operator Matrix<const double>() const { return {data, stride}; }
  };
  using Out = Matrix<double>;
  using In = Matrix<const double>;

  /// What a number of rows or columns is filled up to.
  static constexpr int filled(const int n)
  {
    return (n + rows - 1) / rows * rows;
  }

  /// C = A Bᵀ, of @p n_rows x @p n_columns with @p depth columns in A and B.
  static void set_product(int n_rows, int n_columns, int depth, In A, In B, Out C);
  /// C -= A Bᵀ, of @p n_rows x @p n_columns with @p depth columns in A and B.
  static void subtract_product(int n_rows, int n_columns, int depth, In A, In B, Out C);
  /// A = A Lᵀ with a lower triangular L of @p n columns, zero above its diagonal; of A @p n_rows rows.
  static void multiply_by_transposed(int n_rows, int n, In L, Out A);
  /// W += A Aᵀ below the diagonal (and in part above), of @p n rows, with @p depth columns in A.
  static void add_square(int n, int depth, In A, Out W);
  /// y -= A x, of @p n_rows x @p n_columns.
  static void subtract_times(int n_rows, int n_columns, In A, const double *x, double *y);
  /// y -= Aᵀ x, of @p n_rows x @p n_columns.
  static void subtract_transposed_times(int n_rows, int n_columns, In A, const double *x, double *y);
};
} // namespace softgrain

#endif
