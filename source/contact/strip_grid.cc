// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/contact/strip_grid.h>

#include <cmath>

namespace softgrain::contact
{
namespace
{
/// Cells for @p n_disks: enough for a loose packing, few enough to be looked through.
double most_cells(const std::size_t n_disks)
{
  return 4. * n_disks + 1024.;
}
} // namespace

bool is_sparse(const std::array<double, 2> &lower,
               const std::array<double, 2> &upper,
               const std::size_t n_disks,
               const double size)
{
  return !((upper[0] - lower[0]) / size * ((upper[1] - lower[1]) / size) <= most_cells(n_disks) &&
           (upper[0] - lower[0]) / size <= most_cells(n_disks) &&
           (upper[1] - lower[1]) / size <= most_cells(n_disks));
}

std::vector<StripGrid::Span> joined(std::vector<StripGrid::Span> spans, const double size)
{
  std::sort(spans.begin(), spans.end());
  std::vector<StripGrid::Span> result;
  for (const StripGrid::Span &span : spans)
    if (result.empty() || span[0] - result.back()[1] > size)
      result.push_back(span);
    else
      result.back()[1] = std::max(result.back()[1], span[1]);
  return result;
}

std::vector<StripGrid::Span>
spans_of(const std::vector<std::array<double, 2>> &positions, const std::size_t n, const double size)
{
  std::vector<StripGrid::Span> spans(n);
  for (std::size_t i = 0; i < n; ++i)
    spans[i] = {{positions[i][0], positions[i][0]}};
  return joined(std::move(spans), size);
}

StripGrid::StripGrid(const std::array<double, 2> &lower_corner,
                     const std::array<double, 2> &upper,
                     const std::size_t n_disks,
                     const double size,
                     const std::vector<StripGrid::Span> &spans)
    : lower(lower_corner), cell(size)
{
  if (spans.empty())
  {
    n_columns = static_cast<std::size_t>((upper[0] - lower[0]) / cell) + 1;
    n_rows = static_cast<std::size_t>((upper[1] - lower[1]) / cell) + 1;
  }
  else
  {
    for (const StripGrid::Span &span : spans)
    {
      const std::size_t n = static_cast<std::size_t>((span[1] - span[0]) / cell) + 1;
      pieces.push_back({span[0], n_columns, n_columns + n});
      n_columns += n;
    }
    // An odd number: bodies at round distances do not all come to the same rows.
    wraps = true;
    n_rows = static_cast<std::size_t>(most_cells(n_disks) / static_cast<double>(n_columns)) | 1;
    n_rows = std::max<std::size_t>(n_rows, 5);
  }
  const double per_column = static_cast<double>(n_disks) / n_columns;
  width = std::max<std::size_t>(1, std::lround(disks_per_strip / per_column));
}

const StripGrid::Piece &StripGrid::piece_of(const double x) const
{
  const auto after = std::upper_bound(pieces.begin(), pieces.end(), x,
                                      [](const double a, const Piece &piece) { return a < piece.start; });
  return *(after == pieces.begin() ? after : after - 1);
}

std::size_t StripGrid::column_of_piece(const double x) const
{
  const Piece &piece = piece_of(x);
  const double columns = std::max(0., (x - piece.start) / cell);
  return std::min(piece.first + static_cast<std::size_t>(columns), piece.end - 1);
}
} // namespace softgrain::contact
