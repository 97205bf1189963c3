// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/preparation.h>
#include <softgrain/packing/shaken_disks.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace softgrain
{
namespace
{
/// Rounds in which the box must lose some of its edges, else the disks count as jammed.
constexpr unsigned int patience = 4000;
constexpr double least_progress = 1e-4;
/// Attempts for all disks together on the way from loose to dense, and rounds of them, at least and at most:
/// the slower the box shrinks, the denser they come to lie.
constexpr double attempts = 3e7, fewest_rounds = 3e3, most_rounds = 3e4;
/// Part that the edges lose on that way, about.
constexpr double whole_way = 0.1;
/// Part of all attempts in which two disks change places.
constexpr double swaps = 0.2;
/// Distance that is kept so that rounding makes no overlap.
constexpr double slack = 1e-12;
} // namespace

ShakenDisks::ShakenDisks(std::vector<Place> places,
                         std::vector<double> radii,
                         const Place &half,
                         const std::array<bool, 2> &periodic)
    : centers(std::move(places))
    , radius(std::move(radii))
    , edges(half)
    , periodic(periodic)
    , mean(std::accumulate(radius.begin(), radius.end(), 0.) / radius.size())
    , largest(*std::max_element(radius.begin(), radius.end()))
    , step(0.05 * mean)
    , cell(radius.size())
{
}

std::size_t ShakenDisks::cell_of(const Place &place) const
{
  std::array<int, 2> index;
  for (unsigned int d = 0; d < 2; ++d)
    index[d] =
        std::clamp(static_cast<int>((place[d] / (2. * edges[d]) + 0.5) * n_cells[d]), 0, n_cells[d] - 1);
  return static_cast<std::size_t>(index[0]) * n_cells[1] + index[1];
}

void ShakenDisks::fill_cells()
{
  // No disk reaches farther than into the next cell.
  for (unsigned int d = 0; d < 2; ++d)
    n_cells[d] = std::max(1, static_cast<int>(edges[d] / largest * (1. - 1e-9)));
  cells.assign(static_cast<std::size_t>(n_cells[0]) * n_cells[1], {});
  for (std::size_t i = 0; i < centers.size(); ++i)
  {
    cell[i] = cell_of(centers[i]);
    cells[cell[i]].push_back(i);
  }
}

ShakenDisks::Place ShakenDisks::apart(const Place &a, const Place &b) const
{
  Place result;
  for (unsigned int d = 0; d < 2; ++d)
  {
    result[d] = a[d] - b[d];
    if (periodic[d])
      result[d] -= 2. * edges[d] * std::round(result[d] / (2. * edges[d]));
  }
  return result;
}

bool ShakenDisks::inside(const Place &place, const double r) const
{
  for (unsigned int d = 0; d < 2; ++d)
    if (!periodic[d] && std::abs(place[d]) + r > edges[d] * (1. - slack))
      return false;
  return true;
}

template <class Work>
bool ShakenDisks::around(const Place &place, const Work &work) const
{
  const std::size_t own = cell_of(place);
  const int column = own / n_cells[1], row = own % n_cells[1];
  // With few cells the same one must not be looked at twice.
  const int wide = n_cells[0] > 2 ? 1 : 0, high = n_cells[1] > 2 ? 1 : 0;
  const int first_x = wide ? column - 1 : 0, last_x = wide ? column + 1 : n_cells[0] - 1;
  const int first_y = high ? row - 1 : 0, last_y = high ? row + 1 : n_cells[1] - 1;
  for (int x = first_x; x <= last_x; ++x)
    for (int y = first_y; y <= last_y; ++y)
    {
      const int cx = (x + n_cells[0]) % n_cells[0], cy = (y + n_cells[1]) % n_cells[1];
      if ((cx != x && !periodic[0]) || (cy != y && !periodic[1]))
        continue;
      for (const std::uint32_t j : cells[static_cast<std::size_t>(cx) * n_cells[1] + cy])
        if (!work(j))
          return false;
    }
  return true;
}

bool ShakenDisks::is_free(const std::size_t i, const Place &place, const double r) const
{
  return inside(place, r) && around(place,
                                    [&](const std::uint32_t j)
                                    {
                                      const Place gap = apart(place, centers[j]);
                                      const double reach = (r + radius[j]) * (1. + slack);
                                      return j == i || gap[0] * gap[0] + gap[1] * gap[1] >= reach * reach;
                                    });
}

bool ShakenDisks::move(const std::size_t i, const Place &way)
{
  Place place;
  for (unsigned int d = 0; d < 2; ++d)
  {
    place[d] = centers[i][d] + way[d];
    if (periodic[d])
      place[d] -= 2. * edges[d] * std::round(place[d] / (2. * edges[d]));
  }
  if (!is_free(i, place, radius[i]))
    return false;
  centers[i] = place;
  if (const std::size_t now = cell_of(place); now != cell[i])
  {
    std::vector<std::uint32_t> &old = cells[cell[i]];
    old.erase(std::find(old.begin(), old.end(), i));
    cells[now].push_back(i);
    cell[i] = now;
  }
  return true;
}

bool ShakenDisks::swap(const std::size_t i, const std::size_t j)
{
  if (radius[i] == radius[j])
    return false;
  const Place a = centers[i], b = centers[j];
  const auto exchange = [&]()
  {
    std::swap(centers[i], centers[j]);
    if (cell[i] == cell[j])
      return;
    std::replace(cells[cell[i]].begin(), cells[cell[i]].end(), static_cast<std::uint32_t>(i),
                 static_cast<std::uint32_t>(j));
    // The other cell has j alone: the first has just got it.
    std::replace(cells[cell[j]].begin(), cells[cell[j]].end(), static_cast<std::uint32_t>(j),
                 static_cast<std::uint32_t>(i));
    std::swap(cell[i], cell[j]);
  };
  exchange();
  if (is_free(i, b, radius[i]) && is_free(j, a, radius[j]))
    return true;
  exchange();
  return false;
}

double ShakenDisks::room() const
{
  double factor = 0.;
  for (std::size_t i = 0; i < centers.size(); ++i)
  {
    for (unsigned int d = 0; d < 2; ++d)
      if (!periodic[d])
        // |place| shrinks with the edges, the radius does not.
        factor = std::max(factor, radius[i] / (edges[d] - std::abs(centers[i][d])));
    around(centers[i],
           [&](const std::uint32_t j)
           {
             if (j == i)
               return true;
             const Place gap = apart(centers[i], centers[j]);
             factor = std::max(factor, (radius[i] + radius[j]) / std::hypot(gap[0], gap[1]));
             return true;
           });
  }
  return std::min(1., factor * (1. + 10. * slack));
}

void ShakenDisks::scale_by(const double factor)
{
  for (Place &place : centers)
    for (double &component : place)
      component *= factor;
  for (double &edge : edges)
    edge *= factor;
}

bool ShakenDisks::shrink(const double end, Uniform &random)
{
  const Preparation telling("the packing", centers.size());
  const std::size_t n = centers.size();
  double remembered = edges[0];
  const double slowest = 1. - whole_way / std::clamp(attempts / n, fewest_rounds, most_rounds);
  for (unsigned int round = 1; edges[0] > end * (1. + 1e-12); ++round)
  {
    fill_cells();
    std::size_t moved = 0, moves = 0;
    for (std::size_t attempt = 0; attempt < n; ++attempt)
    {
      const std::size_t i = std::min<std::size_t>(n - 1, n * random());
      if (random() < swaps)
      {
        swap(i, std::min<std::size_t>(n - 1, n * random()));
        continue;
      }
      ++moves;
      const double x = 2. * random() - 1., y = 2. * random() - 1.;
      moved += move(i, {step * x, step * y}) ? 1 : 0;
    }
    // About a third of all moves should succeed.
    step = std::clamp(step * (3 * moved > moves ? 1.05 : 0.95), 1e-6 * mean, 0.5 * mean);
    scale_by(std::max({end / edges[0], slowest, room()}));
    if (round % patience == 0)
    {
      if (edges[0] > (1. - least_progress) * remembered)
        return false;
      remembered = edges[0];
    }
  }
  return true;
}
} // namespace softgrain
