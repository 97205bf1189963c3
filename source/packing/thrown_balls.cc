// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/packing/thrown_balls.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>

namespace softgrain
{
namespace
{
double length(const std::array<double, 2> &vector)
{
  return std::hypot(vector[0], vector[1]);
}
double length(const std::array<double, 3> &vector)
{
  return std::hypot(vector[0], vector[1], vector[2]);
}

/// The box in cells that no ball is wider than, with the balls that lie in them already.
template <int dim>
class ThrownInto
{
public:
  using Place = std::array<double, dim>;
  using Cell = std::array<int, dim>;

  ThrownInto(const std::vector<double> &radius, const Place &half, const std::array<bool, dim> &periodic)
      : radius(radius), half(half), periodic(periodic), places(radius.size())
  {
    const double largest = *std::max_element(radius.begin(), radius.end());
    // In a box that is nearly empty more cells than balls serve nobody.
    const double most = 4. * std::pow(static_cast<double>(radius.size()), 1. / dim) + 1.;
    std::size_t n = 1;
    for (unsigned int d = 0; d < dim; ++d)
      n *= n_cells[d] = std::max(1, static_cast<int>(std::min(half[d] / largest, most)));
    cells.resize(n);
  }

  /// @return whether ball @p i found a free place
  bool place(const std::uint32_t i, Uniform &random)
  {
    constexpr unsigned int most_attempts = 1000000;
    for (unsigned int attempt = 0; attempt < most_attempts; ++attempt)
    {
      Cell cell;
      for (unsigned int d = 0; d < dim; ++d)
      {
        places[i][d] = (2. * random() - 1.) * (half[d] - (periodic[d] ? 0. : radius[i]));
        cell[d] = std::min(n_cells[d] - 1,
                           static_cast<int>((places[i][d] + half[d]) / (2. * half[d]) * n_cells[d]));
      }
      if (overlaps(i, cell))
        continue;
      cells[index_of(cell)].push_back(i);
      return true;
    }
    return false;
  }

  std::vector<Place> take() { return std::move(places); }

private:
  std::size_t index_of(const Cell &cell) const
  {
    std::size_t index = 0;
    for (unsigned int d = 0; d < dim; ++d)
      index = index * n_cells[d] + cell[d];
    return index;
  }

  Place apart(const Place &a, const Place &b) const
  {
    Place result;
    for (unsigned int d = 0; d < dim; ++d)
    {
      result[d] = a[d] - b[d];
      if (periodic[d])
        result[d] -= 2. * half[d] * std::round(result[d] / (2. * half[d]));
    }
    return result;
  }

  bool overlaps(const std::uint32_t i, const Cell &cell) const
  {
    constexpr int n_around = dim == 2 ? 9 : 27;
    for (int n = 0; n < n_around; ++n)
    {
      Cell there;
      bool inside = true;
      for (int d = 0, rest = n; d < dim; ++d, rest /= 3)
      {
        // Beyond a wall there is only the wall; beyond a periodic side the other end.
        const int beside = cell[d] + rest % 3 - 1;
        there[d] = (beside + n_cells[d]) % n_cells[d];
        inside = inside && (there[d] == beside || periodic[d]);
      }
      if (inside)
        for (const std::uint32_t j : cells[index_of(there)])
          if (length(apart(places[i], places[j])) < radius[i] + radius[j])
            return true;
    }
    return false;
  }

  const std::vector<double> &radius;
  const Place half;
  const std::array<bool, dim> periodic;
  std::vector<Place> places;
  Cell n_cells;
  std::vector<std::vector<std::uint32_t>> cells;
};
} // namespace

template <int dim>
std::vector<std::array<double, dim>> thrown_balls(const std::vector<double> &radius,
                                                  const std::array<double, dim> &half,
                                                  const std::array<bool, dim> &periodic,
                                                  Uniform &random)
{
  std::vector<std::uint32_t> order(radius.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return radius[a] > radius[b]; });
  // A large ball in the middle of a small box may leave no room for the next one, so all are thrown again.
  constexpr unsigned int most_rounds = 20;
  for (unsigned int round = 0; round < most_rounds; ++round)
  {
    ThrownInto<dim> box(radius, half, periodic);
    if (std::all_of(order.begin(), order.end(), [&](const std::uint32_t i) { return box.place(i, random); }))
      return box.take();
  }
  throw InputError(std::string("'Packing': the ") + (dim == 2 ? "disks" : "balls") +
                   " do not fit into the box, they are too large for it");
}

template std::vector<std::array<double, 2>> thrown_balls<2>(const std::vector<double> &,
                                                            const std::array<double, 2> &,
                                                            const std::array<bool, 2> &,
                                                            Uniform &);
template std::vector<std::array<double, 3>> thrown_balls<3>(const std::vector<double> &,
                                                            const std::array<double, 3> &,
                                                            const std::array<bool, 3> &,
                                                            Uniform &);
} // namespace softgrain
