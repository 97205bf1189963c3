// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/linear/dense_kernels.h>

#include <algorithm>
#include <type_traits>

namespace softgrain
{
namespace
{
using Kernels = DenseKernels;
using Lanes = Kernels::Lanes;
using In = Kernels::In;
using Out = Kernels::Out;

constexpr int lanes = Kernels::lanes;
// As many sums as fit into the registers: 32 with AVX-512, else 16.
constexpr int tile_columns = lanes == 8 ? 8 : 4;
constexpr int tile_vectors = 2;

/// Sums of a tile of `vectors` times lanes rows.
template <int n_vectors>
struct Tile
{
  static constexpr int vectors = n_vectors;
  Lanes sum[tile_columns][vectors];

  void product(const int depth, const In &A, const In &B)
  {
#pragma GCC unroll 16
    for (int n = 0; n < tile_columns; ++n)
#pragma GCC unroll 16
      for (int v = 0; v < vectors; ++v)
        sum[n][v] = Lanes{};
    for (int k = 0; k < depth; ++k)
    {
      Lanes column[vectors];
#pragma GCC unroll 16
      for (int v = 0; v < vectors; ++v)
        column[v] = Kernels::load(A.at(v * lanes, k));
      const double *const factor = B.at(0, k);
#pragma GCC unroll 16
      for (int n = 0; n < tile_columns; ++n)
#pragma GCC unroll 16
        for (int v = 0; v < vectors; ++v)
          sum[n][v] += column[v] * factor[n];
    }
  }

  /// Calls write(place, sum) for all values.
  template <class Write>
  void write_to(const Out &C, const Write &write) const
  {
#pragma GCC unroll 16
    for (int n = 0; n < tile_columns; ++n)
#pragma GCC unroll 16
      for (int v = 0; v < vectors; ++v)
        write(C.at(v * lanes, n), sum[n][v]);
  }
};

// Calls strip(an empty tile, row) for strips of rows from @p first on.
template <class Strip>
void for_strips(const int first, const int n_rows, const Strip &strip)
{
  int row = first;
  for (; row + tile_vectors * lanes <= n_rows; row += tile_vectors * lanes)
    strip(Tile<tile_vectors>(), row);
  for (; row < n_rows; row += lanes)
    strip(Tile<1>(), row);
}

/// Calls work(number of vectors, row) for pieces of rows that fit into the registers; columns are then read
/// as they lie in memory.
template <class Work>
void for_pieces(const int n_rows, const Work &work)
{
  int row = 0;
  for (; row + 8 * lanes <= n_rows; row += 8 * lanes)
    work(std::integral_constant<int, 8>(), row);
  if (row + 4 * lanes <= n_rows)
  {
    work(std::integral_constant<int, 4>(), row);
    row += 4 * lanes;
  }
  if (row + 2 * lanes <= n_rows)
  {
    work(std::integral_constant<int, 2>(), row);
    row += 2 * lanes;
  }
  if (row < n_rows)
    work(std::integral_constant<int, 1>(), row);
}

template <class Tile>
void add(Tile &tile, const int depth, const In &A, const In &B, const Out &C, const double sign)
{
  tile.product(depth, A, B);
  tile.write_to(C, [sign](double *const place, const Lanes &sum)
                { Kernels::store(place, Kernels::load(place) + sign * sum); });
}
} // namespace

void DenseKernels::set_product(
    const int n_rows, const int n_columns, const int depth, const In A, const In B, const Out C)
{
  for_strips(0, n_rows,
             [&](auto tile, const int row)
             {
               for (int n = 0; n < n_columns; n += tile_columns)
               {
                 tile.product(depth, A.from(row, 0), B.from(n, 0));
                 tile.write_to(C.from(row, n), store);
               }
             });
}

void DenseKernels::subtract_product(
    const int n_rows, const int n_columns, const int depth, const In A, const In B, const Out C)
{
  for_strips(0, n_rows,
             [&](auto tile, const int row)
             {
               for (int n = 0; n < n_columns; n += tile_columns)
                 add(tile, depth, A.from(row, 0), B.from(n, 0), C.from(row, n), -1.);
             });
}

void DenseKernels::multiply_by_transposed(const int n_rows, const int n, const In L, const Out A)
{
  // From the last columns to the first: a column of the product needs none behind it.
  for_strips(0, n_rows,
             [&](auto tile, const int row)
             {
               for (int j = n - tile_columns; j >= 0; j -= tile_columns)
               {
                 tile.product(j + tile_columns, A.from(row, 0), L.from(j, 0));
                 tile.write_to(A.from(row, j), store);
               }
             });
}

void DenseKernels::add_square(const int n, const int depth, const In A, const Out W)
{
  for_strips(0, n,
             [&](auto tile, const int row)
             {
               const int end = row + decltype(tile)::vectors * lanes;
               for (int j = 0; j < end; j += tile_columns)
                 add(tile, depth, A.from(row, 0), A.from(j, 0), W.from(row, j), 1.);
             });
}

void DenseKernels::subtract_times(
    const int n_rows, const int n_columns, const In A, const double *const x, double *const y)
{
  for_pieces(n_rows,
             [&](auto piece, const int row)
             {
               constexpr int n = decltype(piece)::value;
               Lanes sum[n];
#pragma GCC unroll 16
               for (int v = 0; v < n; ++v)
                 sum[v] = load(y + row + v * lanes);
               for (int k = 0; k < n_columns; ++k)
               {
                 const double *const column = A.at(row, k);
#pragma GCC unroll 16
                 for (int v = 0; v < n; ++v)
                   sum[v] -= load(column + v * lanes) * x[k];
               }
#pragma GCC unroll 16
               for (int v = 0; v < n; ++v)
                 store(y + row + v * lanes, sum[v]);
             });
}

void DenseKernels::subtract_transposed_times(
    const int n_rows, const int n_columns, const In A, const double *const x, double *const y)
{
  for_pieces(n_rows,
             [&](auto piece, const int row)
             {
               constexpr int n = decltype(piece)::value;
               Lanes own[n];
#pragma GCC unroll 16
               for (int v = 0; v < n; ++v)
                 own[v] = load(x + row + v * lanes);
               for (int k = 0; k < n_columns; ++k)
               {
                 const double *const column = A.at(row, k);
                 Lanes sum = Lanes{};
#pragma GCC unroll 16
                 for (int v = 0; v < n; ++v)
                   sum += load(column + v * lanes) * own[v];
                 double total = 0.;
                 for (int l = 0; l < lanes; ++l)
                   total += sum[l];
                 y[k] -= total;
               }
             });
}
} // namespace softgrain
