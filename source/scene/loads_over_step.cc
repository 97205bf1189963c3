// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/scene/loads_over_step.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
namespace
{
/**
 * @brief Mean of exp(s @p rate) @p start for s from 0 to 1: what changes by itself, exactly.
 *
 * The series of the mean P and of the exponential E are summed for rate / 2^k and then doubled k times:
 * P(2 z) = (E(z) + 1) P(z) / 2, E(2 z) = E(z)^2.
 */
template <int dim>
dealii::Tensor<1, dim> mean_on_its_way(dealii::Tensor<2, dim> rate, const dealii::Tensor<1, dim> &start)
{
  constexpr double small = 0.5;
  constexpr unsigned int n_terms = 14; // small^14 / 15! is below rounding
  const double size = rate.norm();
  if (size == 0.)
    return start;
  const int halvings = std::max(0, static_cast<int>(std::ceil(std::log2(size / small))));
  rate *= std::ldexp(1., -halvings);
  dealii::Tensor<2, dim> one;
  for (unsigned int d = 0; d < dim; ++d)
    one[d][d] = 1.;
  dealii::Tensor<2, dim> mean = one, term = one;
  for (unsigned int n = 1; n <= n_terms; ++n)
  {
    term = term * rate / (n + 1.);
    mean += term;
  }
  dealii::Tensor<2, dim> grown = one + rate * mean;
  for (int k = 0; k < halvings; ++k)
  {
    mean = 0.5 * ((grown + one) * mean);
    grown = grown * grown;
  }
  return mean * start;
}
} // namespace

template <int dim>
dealii::Tensor<1, dim> mean_acceleration(const Load<dim> &load, const LoadPlace<dim> &place, const double dt)
{
  if (!load.sees_velocity())
    return load.acceleration(place);
  LoadPlace<dim> halfway = place;
  halfway.now += 0.5 * dt * place.velocity;
  halfway.time += 0.5 * dt;
  return mean_on_its_way<dim>(dt * load.velocity_tangent(halfway), load.acceleration(halfway));
}

template <int dim>
void mean_accelerations(const std::vector<const Load<dim> *> &loads,
                        const LoadPlace<dim> &place,
                        const double dt,
                        std::vector<dealii::Tensor<1, dim>> &means)
{
  means.clear();
  dealii::Tensor<1, dim> sum;
  for (const Load<dim> *const load : loads)
  {
    means.push_back(mean_acceleration(*load, place, dt));
    sum += means.back();
  }
  if (loads.size() == 1 ||
      std::none_of(loads.begin(), loads.end(), [](const auto *const load) { return load->sees_velocity(); }))
    return;
  const std::vector<dealii::Tensor<1, dim>> alone = means;
  for (std::size_t i = 0; i < loads.size(); ++i)
    if (loads[i]->sees_velocity())
    {
      LoadPlace<dim> with_others = place;
      with_others.velocity += 0.5 * dt * (sum - alone[i]);
      means[i] = mean_acceleration(*loads[i], with_others, dt);
    }
}

template dealii::Tensor<1, 2> mean_acceleration<2>(const Load<2> &, const LoadPlace<2> &, double);
template dealii::Tensor<1, 3> mean_acceleration<3>(const Load<3> &, const LoadPlace<3> &, double);
template void mean_accelerations<2>(const std::vector<const Load<2> *> &,
                                    const LoadPlace<2> &,
                                    double,
                                    std::vector<dealii::Tensor<1, 2>> &);
template void mean_accelerations<3>(const std::vector<const Load<3> *> &,
                                    const LoadPlace<3> &,
                                    double,
                                    std::vector<dealii::Tensor<1, 3>> &);
} // namespace softgrain
