// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_strip_grid_h
#define softgrain_contact_strip_grid_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace softgrain::contact
{
/// Rows of cells that are far away come round again: whole numbers below a turn are exact, also after adding
/// one.
inline double within_turn(const double row)
{
  constexpr double turn = 1125899906842624.; // 2^50
  const double rest = std::fmod(row, turn);
  return rest < 0. ? rest + turn : rest;
}

/**
 * @brief Cells in which disks look for their neighbours, and the vertical strips of some columns of cells
 * that make the tiles of a NeighbourList.
 *
 * The number of cells grows with the number of disks, the size of a cell never does. Where a few disks are
 * far away, columns are made only where there are disks, and rows repeat: disks in one cell may then be far
 * from each other, but those in cells that do not touch are never near.
 */
struct StripGrid
{
  /// Interval along x from the first to the last of some disks, none of which is farther than a cell from the
  /// next [m].
  using Span = std::array<double, 2>;

  /// Disks per strip that keep it in the cache and leave enough strips for all threads.
  static constexpr double disks_per_strip = 1000.;

  StripGrid() = default;

  /**
   * @param lower,upper least and largest coordinates of the disks [m]
   * @param n_disks their number
   * @param size of a cell [m]
   * @param spans all of the disks where is_sparse(), else none
   */
  StripGrid(const std::array<double, 2> &lower,
            const std::array<double, 2> &upper,
            std::size_t n_disks,
            double size,
            const std::vector<Span> &spans = {});

  std::size_t column(const std::array<double, 2> &x) const
  {
    return pieces.empty() ? index(x, 0, n_columns) : column_of_piece(x[0]);
  }
  std::size_t row(const std::array<double, 2> &x) const
  {
    return wraps ? wrapped(x[1]) : index(x, 1, n_rows);
  }
  /// Column of a cell that is @p factor times smaller, within column().
  double fine_column(const std::array<double, 2> &x, const double factor) const
  {
    const double first = pieces.empty() ? lower[0] : piece_of(x[0]).start;
    const std::size_t in_piece = column(x) - (pieces.empty() ? 0 : piece_of(x[0]).first);
    const double part = std::floor(((x[0] - first) / cell - static_cast<double>(in_piece)) * factor);
    return static_cast<double>(column(x)) * factor + std::max(0., std::min(part, factor - 1.));
  }
  /// Row of such a cell; far rows come round again.
  double fine_row(const std::array<double, 2> &x, const double factor) const
  {
    return within_turn(std::floor(x[1] / cell * factor));
  }
  std::size_t strip(const std::array<double, 2> &x) const { return column(x) / width; }
  std::size_t n_strips() const { return (n_columns + width - 1) / width; }

  std::array<double, 2> lower{};
  double cell = 1.; ///< [m]
  std::size_t n_columns = 0, n_rows = 0;
  std::size_t width = 1; ///< columns of a strip
  bool wraps = false;    ///< whether the first row comes after the last one

private:
  /// Columns of one span.
  struct Piece
  {
    double start;      ///< [m]
    std::size_t first; ///< column
    std::size_t end;   ///< column after the last one
  };
  std::vector<Piece> pieces;

  const Piece &piece_of(double x) const;
  std::size_t column_of_piece(double x) const;
  /// Rows are counted from y = 0, not from a disk that may be so far away that all others have one distance.
  std::size_t wrapped(const double y) const
  {
    const double n = static_cast<double>(n_rows), rest = std::fmod(std::floor(y / cell), n);
    return static_cast<std::size_t>(rest < 0. ? rest + n : rest);
  }
  std::size_t index(const std::array<double, 2> &x, const unsigned int d, const std::size_t n) const
  {
    return std::min<std::size_t>((x[d] - lower[d]) / cell, n - 1);
  }
};

/// Whether a box full of cells of @p size [m] would have many more cells than there are disks.
/// @param lower,upper least and largest coordinates of the disks [m]
bool is_sparse(const std::array<double, 2> &lower,
               const std::array<double, 2> &upper,
               std::size_t n_disks,
               double size);

/// Joins @p spans that are no farther than @p size from each other: the same in whatever parts they came.
std::vector<StripGrid::Span> joined(std::vector<StripGrid::Span> spans, double size);

/// Spans of the first @p n of @p positions.
std::vector<StripGrid::Span>
spans_of(const std::vector<std::array<double, 2>> &positions, std::size_t n, double size);
} // namespace softgrain::contact

#endif
