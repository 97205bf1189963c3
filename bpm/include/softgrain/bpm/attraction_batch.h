// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_attraction_batch_h
#define softgrain_bpm_attraction_batch_h

#include <softgrain/bpm/attraction.h>

#include <array>
#include <cstdint>
#include <vector>

namespace softgrain::bpm
{
/// Pairs that attract each other by one law, in the form that a law wants.
template <int dim>
class AttractionBatch
{
public:
  using Vector = std::array<double, dim>;

  void clear()
  {
    first.clear();
    second.clear();
    distance.clear();
    sum.clear();
    direction.clear();
  }

  /**
   * @param a,b the primaries
   * @param apart distance of their centres [m]
   * @param radii their sum [m]
   * @param towards unit, from b to a
   */
  void add(const std::uint32_t a,
           const std::uint32_t b,
           const double apart,
           const double radii,
           const Vector &towards)
  {
    first.push_back(a);
    second.push_back(b);
    distance.push_back(apart);
    sum.push_back(radii);
    direction.push_back(towards);
  }

  /**
   * @brief Adds forces and energies of the pairs, and forgets them.
   *
   * @param law of all of them
   * @param strength of every primary over that of the law, a pair has the mean; empty: 1
   * @param force on every primary
   * @param energy sum
   */
  void finish(const Attraction *const law,
              const std::vector<double> &strength,
              std::vector<Vector> &force,
              double &energy)
  {
    const std::size_t n = first.size();
    if (n == 0)
      return;
    size.resize(n);
    stored.resize(n);
    law->evaluate(n, distance.data(), sum.data(), size.data(), stored.data());
    for (std::size_t k = 0; k < n && !strength.empty(); ++k)
    {
      const double factor = 0.5 * (strength[first[k]] + strength[second[k]]);
      size[k] *= factor;
      stored[k] *= factor;
    }
    for (std::size_t k = 0; k < n; ++k)
    {
      Vector &on_a = force[first[k]], &on_b = force[second[k]];
      for (unsigned int d = 0; d < dim; ++d)
      {
        const double f = size[k] * direction[k][d];
        on_a[d] -= f;
        on_b[d] += f;
      }
      energy += stored[k];
    }
    clear();
  }

private:
  std::vector<std::uint32_t> first, second;
  std::vector<double> distance, sum, size, stored;
  std::vector<Vector> direction;
};
} // namespace softgrain::bpm

#endif
