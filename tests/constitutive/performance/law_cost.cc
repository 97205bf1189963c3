// SPDX-License-Identifier: LGPL-2.1-or-later
// Nanoseconds per point of every law, in batches of 100: stress alone (an explicit step) and stress with
// tangent (a Newton iteration). Each number is the best of many runs, which a busy machine disturbs least.
#include "../law_response.h"
#include "../modules/energy_only.cc"

#include <chrono>
#include <functional>
#include <iomanip>
#include <iostream>

namespace
{
double best_nanoseconds(const std::function<void()> &batch, const unsigned int n_points)
{
  using Clock = std::chrono::steady_clock;
  const unsigned int repetitions = 20;
  double best = 1e300;
  // A law of 10 ns per point comes to a thousand runs.
  const auto end = Clock::now() + std::chrono::milliseconds(100);
  for (unsigned int run = 0; run < 5 || Clock::now() < end; ++run)
  {
    const auto start = Clock::now();
    for (unsigned int i = 0; i < repetitions; ++i)
      batch();
    const std::chrono::duration<double, std::nano> time = Clock::now() - start;
    best = std::min(best, time.count() / repetitions / n_points);
  }
  return best;
}

template <int dim>
double measure(const std::string &name)
{
  using namespace softgrain::test;
  const auto law = make_law<dim>(name);
  const unsigned int n = 100;
  RandomNumbers random;
  std::vector<Tensor<2, dim>> F(n), increment(n);
  for (unsigned int q = 0; q < n; ++q)
  {
    increment[q] = random.tensor<dim>(0.2);
    F[q] = dealii::unit_symmetric_tensor<dim>() + increment[q];
  }
  std::vector<double> history(n * law->n_history()), history_new = history;
  for (unsigned int q = 0; q < n; ++q)
    law->initial_history(history.data() + q * law->n_history());
  std::vector<SymmetricTensor<2, dim>> stress(n);
  std::vector<SymmetricTensor<4, dim>> tangent(n);
  const Inputs<dim> in = {n, F.data(), increment.data(), history.data(), 0.1, 0.1};
  Outputs<dim> out;
  out.stress = stress.data();
  out.history_new = history_new.data();
  const double stress_only = best_nanoseconds([&] { law->update(in, out); }, n);
  out.tangent = tangent.data();
  const double with_tangent = best_nanoseconds([&] { law->update(in, out); }, n);
  std::cout << std::setw(16) << name << "  " << dim << "D  " << std::fixed << std::setprecision(1)
            << std::setw(8) << stress_only << " ns  with tangent " << std::setw(8) << with_tangent << " ns\n";
  return stress_only;
}
} // namespace

int main()
{
  double neo_hookean = 0;
  for (const std::string &name : softgrain::constitutive::law_names())
  {
    const double cost = measure<2>(name);
    measure<3>(name);
    if (name == "neo_hookean")
      neo_hookean = cost;
  }
#ifdef NDEBUG
  const double limit = 100;
#else
  const double limit = 10000;
#endif
  std::cout << "neo_hookean, stress alone in 2D: goal 30 ns, limit of this test " << limit << " ns\n";
  return neo_hookean < limit ? 0 : 1;
}
