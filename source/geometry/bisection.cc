// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/geometry/bisection.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace softgrain
{
namespace
{
template <int dim>
class Bisection
{
public:
  Bisection(const std::vector<dealii::Point<dim>> &centers, const std::vector<double> &weights)
      : part(centers.size(), 0), centers(centers), weights(weights), order(centers.size())
  {
    std::iota(order.begin(), order.end(), 0u);
  }

  /// Shares the things [begin, end) of the order out to the parts [first, first + n).
  void split(const unsigned int begin, const unsigned int end, const unsigned int first, const unsigned int n)
  {
    if (n == 1 || begin == end)
    {
      for (unsigned int i = begin; i < end; ++i)
        part[order[i]] = first;
      return;
    }
    const unsigned int axis = longest_side(begin, end), lower = n / 2;
    std::sort(order.begin() + begin, order.begin() + end,
              [&](const unsigned int a, const unsigned int b)
              { return centers[a][axis] != centers[b][axis] ? centers[a][axis] < centers[b][axis] : a < b; });
    const unsigned int middle = cut(begin, end, lower, n);
    split(begin, middle, first, lower);
    split(middle, end, first + lower, n - lower);
  }

  std::vector<unsigned int> part;

private:
  unsigned int longest_side(const unsigned int begin, const unsigned int end) const
  {
    dealii::Point<dim> least = centers[order[begin]], most = least;
    for (unsigned int i = begin; i < end; ++i)
      for (unsigned int d = 0; d < dim; ++d)
      {
        least[d] = std::min(least[d], centers[order[i]][d]);
        most[d] = std::max(most[d], centers[order[i]][d]);
      }
    unsigned int axis = 0;
    for (unsigned int d = 1; d < dim; ++d)
      if (most[d] - least[d] > most[axis] - least[axis])
        axis = d;
    return axis;
  }

  /// Where the first @p lower of @p n parts end.
  unsigned int
  cut(const unsigned int begin, const unsigned int end, const unsigned int lower, const unsigned int n) const
  {
    double total = 0.;
    for (unsigned int i = begin; i < end; ++i)
      total += weights[order[i]];
    const double wanted = total * lower / n;
    unsigned int middle = begin;
    // One more as long as that brings the sum nearer to what is wanted.
    for (double sum = 0.;
         middle < end && std::abs(sum + weights[order[middle]] - wanted) <= std::abs(sum - wanted); ++middle)
      sum += weights[order[middle]];
    const unsigned int count = end - begin;
    if (count < n)
      return begin + std::min(count, lower);
    return std::clamp(middle, begin + lower, end - (n - lower));
  }

  const std::vector<dealii::Point<dim>> &centers;
  const std::vector<double> &weights;
  std::vector<unsigned int> order;
};
} // namespace

template <int dim>
std::vector<unsigned int> bisect(const std::vector<dealii::Point<dim>> &centers,
                                 const std::vector<double> &weights,
                                 const unsigned int n_parts)
{
  Bisection<dim> bisection(centers, weights);
  bisection.split(0, centers.size(), 0, n_parts);
  return bisection.part;
}

template std::vector<unsigned int>
bisect<2>(const std::vector<dealii::Point<2>> &, const std::vector<double> &, unsigned int);
template std::vector<unsigned int>
bisect<3>(const std::vector<dealii::Point<3>> &, const std::vector<double> &, unsigned int);
} // namespace softgrain
