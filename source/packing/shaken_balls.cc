// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/preparation.h>
#include <softgrain/packing/shaken_balls.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace softgrain
{
namespace
{
/// Rounds in which the box must lose some of its edges, else the balls count as jammed.
constexpr unsigned int patience = 4000;
constexpr double least_progress = 1e-4;
/// Attempts for all balls together on the way from loose to dense, and rounds of them, at least and at most:
/// the slower the box shrinks, the denser they come to lie.
constexpr double attempts = 3e7, fewest_rounds = 3e3, most_rounds = 3e4;
/// Part that the edges lose on that way, about.
constexpr double whole_way = 0.1;
/// Part of all attempts in which two balls change places.
constexpr double swaps = 0.2;
/// Distance that is kept so that rounding makes no overlap.
constexpr double slack = 1e-12;
/// Part of its edges that a loose box may lose in a round.
constexpr double quick = 0.01;

double length(const std::array<double, 2> &vector)
{
  return std::hypot(vector[0], vector[1]);
}
double length(const std::array<double, 3> &vector)
{
  return std::hypot(vector[0], vector[1], vector[2]);
}

template <std::size_t dim>
double square(const std::array<double, dim> &vector)
{
  double sum = 0.;
  for (const double component : vector)
    sum += component * component;
  return sum;
}
} // namespace

template <int dim>
ShakenBalls<dim>::ShakenBalls(std::vector<Place> places,
                              std::vector<double> radii,
                              const Place &half,
                              const std::array<bool, dim> &periodic)
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

template <int dim>
typename ShakenBalls<dim>::Cell ShakenBalls<dim>::cell_around(const Place &place) const
{
  Cell index;
  for (unsigned int d = 0; d < dim; ++d)
    index[d] =
        std::clamp(static_cast<int>((place[d] / (2. * edges[d]) + 0.5) * n_cells[d]), 0, n_cells[d] - 1);
  return index;
}

template <int dim>
std::size_t ShakenBalls<dim>::index_of(const Cell &cell) const
{
  std::size_t index = 0;
  for (unsigned int d = 0; d < dim; ++d)
    index = index * n_cells[d] + cell[d];
  return index;
}

template <int dim>
void ShakenBalls<dim>::fill_cells()
{
  // No ball reaches farther than into the next cell.
  std::size_t n = 1;
  for (unsigned int d = 0; d < dim; ++d)
  {
    n_cells[d] = std::max(1, static_cast<int>(edges[d] / largest * (1. - 1e-9)));
    n *= n_cells[d];
  }
  cells.resize(n);
  for (std::vector<std::uint32_t> &one : cells)
    one.clear();
  for (std::size_t i = 0; i < centers.size(); ++i)
  {
    cell[i] = index_of(cell_around(centers[i]));
    cells[cell[i]].push_back(i);
  }
}

template <int dim>
typename ShakenBalls<dim>::Place ShakenBalls<dim>::apart(const Place &a, const Place &b) const
{
  Place result;
  for (unsigned int d = 0; d < dim; ++d)
  {
    result[d] = a[d] - b[d];
    if (periodic[d])
      result[d] -= 2. * edges[d] * std::round(result[d] / (2. * edges[d]));
  }
  return result;
}

template <int dim>
bool ShakenBalls<dim>::inside(const Place &place, const double r) const
{
  for (unsigned int d = 0; d < dim; ++d)
    if (!periodic[d] && std::abs(place[d]) + r > edges[d] * (1. - slack))
      return false;
  return true;
}

template <int dim>
template <class Work>
bool ShakenBalls<dim>::around(const Place &place, const Work &work) const
{
  const Cell own = cell_around(place);
  Cell first, last;
  for (unsigned int d = 0; d < dim; ++d)
  {
    // With few cells the same one must not be looked at twice.
    const bool many = n_cells[d] > 2;
    first[d] = many ? own[d] - 1 : 0;
    last[d] = many ? own[d] + 1 : n_cells[d] - 1;
  }
  for (Cell at = first;;)
  {
    // Beyond a wall there is only the wall; beyond a periodic side the other end.
    Cell wrapped = at;
    bool there = true;
    for (unsigned int d = 0; d < dim; ++d)
    {
      wrapped[d] = (at[d] + n_cells[d]) % n_cells[d];
      there = there && (wrapped[d] == at[d] || periodic[d]);
    }
    if (there)
      for (const std::uint32_t j : cells[index_of(wrapped)])
        if (!work(j))
          return false;
    int d = dim - 1;
    for (; d >= 0 && ++at[d] > last[d]; --d)
      at[d] = first[d];
    if (d < 0)
      return true;
  }
}

template <int dim>
bool ShakenBalls<dim>::is_free(const std::size_t i, const Place &place, const double r) const
{
  return inside(place, r) && around(place,
                                    [&](const std::uint32_t j)
                                    {
                                      const double reach = (r + radius[j]) * (1. + slack);
                                      return j == i || square(apart(place, centers[j])) >= reach * reach;
                                    });
}

template <int dim>
bool ShakenBalls<dim>::move(const std::size_t i, const Place &way)
{
  Place place;
  for (unsigned int d = 0; d < dim; ++d)
  {
    place[d] = centers[i][d] + way[d];
    if (periodic[d])
      place[d] -= 2. * edges[d] * std::round(place[d] / (2. * edges[d]));
  }
  if (!is_free(i, place, radius[i]))
    return false;
  centers[i] = place;
  if (const std::size_t now = index_of(cell_around(place)); now != cell[i])
  {
    std::vector<std::uint32_t> &old = cells[cell[i]];
    old.erase(std::find(old.begin(), old.end(), i));
    cells[now].push_back(i);
    cell[i] = now;
  }
  return true;
}

template <int dim>
bool ShakenBalls<dim>::swap(const std::size_t i, const std::size_t j)
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

template <int dim>
double ShakenBalls<dim>::room() const
{
  double factor = 0.;
  for (std::size_t i = 0; i < centers.size(); ++i)
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (!periodic[d])
        // |place| shrinks with the edges, the radius does not.
        factor = std::max(factor, radius[i] / (edges[d] - std::abs(centers[i][d])));
    around(centers[i],
           [&](const std::uint32_t j)
           {
             if (j != i)
               factor = std::max(factor, (radius[i] + radius[j]) / length(apart(centers[i], centers[j])));
             return true;
           });
  }
  return std::min(1., factor * (1. + 10. * slack));
}

template <int dim>
void ShakenBalls<dim>::scale_by(const double factor)
{
  for (Place &place : centers)
    for (double &component : place)
      component *= factor;
  for (double &edge : edges)
    edge *= factor;
}

template <int dim>
bool ShakenBalls<dim>::shrink(const double end, const double dense, Uniform &random)
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
      Place way;
      for (double &component : way)
        component = step * (2. * random() - 1.);
      moved += move(i, way) ? 1 : 0;
    }
    // About a third of all moves should succeed.
    step = std::clamp(step * (3 * moved > moves ? 1.05 : 0.95), 1e-6 * mean, 0.5 * mean);
    scale_by(std::max({end / edges[0], edges[0] > dense ? 1. - quick : slowest, room()}));
    if (round % patience == 0)
    {
      if (edges[0] > (1. - least_progress) * remembered)
        return false;
      remembered = edges[0];
    }
  }
  return true;
}

template class ShakenBalls<2>;
template class ShakenBalls<3>;
} // namespace softgrain
