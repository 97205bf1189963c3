// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_constitutive_law_point_h
#define softgrain_tests_constitutive_law_point_h

#include "law_response.h"

#include <cmath>

namespace softgrain::test
{
using Settings = std::vector<std::pair<std::string, std::string>>;

/// One point of a law with its past.
template <int dim>
struct LawPoint
{
  std::unique_ptr<Law<dim>> law;
  Tensor<2, dim> F = dealii::unit_symmetric_tensor<dim>();
  std::vector<double> history;
  Response<dim> last;
  double time = 0, work = 0, dissipated = 0, supplied = 0;

  LawPoint(const std::string &name, const Settings &settings)
      : law(make_law<dim>(name, settings)), history(initial_history(*law))
  {
  }

  Response<dim> try_step(const Tensor<2, dim> &F_new, const double dt = 0) const
  {
    return evaluate(*law, {F_new, {}, history, dt, time + dt});
  }

  /// Goes on to @p F_new; work by the trapezoidal rule in the logarithmic step of a motion along fixed axes.
  void go_to(const Tensor<2, dim> &F_new, const double dt = 0)
  {
    const SymmetricTensor<2, dim> before = last.stress;
    last = try_step(F_new, dt);
    for (unsigned int i = 0; i < dim; ++i)
      work += (before[i][i] + last.stress[i][i]) / 2 * std::log(F_new[i][i] / F[i][i]);
    dissipated += last.dissipation;
    supplied += last.supply;
    history = last.history;
    F = F_new;
    time += dt;
  }

  /// What F becomes when x is stretched to exp(strain); the other directions are free of stress where @p free
  /// says so.
  Tensor<2, dim> stretched(const double strain, const bool free, const double dt = 0) const
  {
    Tensor<2, dim> next = F;
    next[0][0] = std::exp(strain);
    for (unsigned int i = 0; free && i < 30; ++i)
    {
      // All lateral stretches are equal; Newton with the modulus of ln(lateral stretch).
      const Response<dim> r = try_step(next, dt);
      double slope = 2 * r.stress[1][1];
      for (unsigned int j = 1; j < dim; ++j)
        slope += r.tangent[1][1][j][j];
      const double change = std::exp(-r.stress[1][1] / slope);
      for (unsigned int j = 1; j < dim; ++j)
        next[j][j] *= change;
    }
    return next;
  }

  void stretch(const double strain, const bool free, const double dt = 0)
  {
    go_to(stretched(strain, free, dt), dt);
  }

  /// Pulls along x until the stress there is @p stress, the sides free; by the secant method.
  void pull(const double stress, const double dt)
  {
    double a = std::log(F[0][0]), b = a + 1e-3;
    const auto rest = [&](const double strain)
    { return try_step(stretched(strain, true, dt), dt).stress[0][0] - stress; };
    double rest_a = rest(a), rest_b = rest(b);
    for (unsigned int i = 0; i < 50 && std::abs(rest_b) > 1e-12 * std::abs(stress); ++i)
    {
      const double c = b - rest_b * (b - a) / (rest_b - rest_a);
      a = b;
      rest_a = rest_b;
      b = c;
      rest_b = rest(b);
    }
    stretch(b, true, dt);
  }
};
} // namespace softgrain::test

#endif
