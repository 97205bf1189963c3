// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_constitutive_law_properties_h
#define softgrain_tests_constitutive_law_properties_h

#include "law_response.h"

#include <softgrain/constitutive/elastic_law.h>

#include <cfenv>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>

namespace softgrain::test
{
/**
 * @brief What every constitutive law must hold, whatever it is: checked on one law.
 *
 * Remembers the worst error of each property over all deformations and parameters that it is shown.
 */
template <int dim>
class LawProperties
{
public:
  explicit LawProperties(const Law<dim> &law)
      : law(law), finite(law.kinematics() == Kinematics::finite_strain)
  {
  }

  /// Runs all checks and prints one line per property. @return whether all hold.
  bool check()
  {
    std::feclearexcept(FE_ALL_EXCEPT);
    check_rest();
    RandomNumbers random;
    for (const Tensor<2, dim> &F : deformations(random))
    {
      // Half of the steps start from a point that has moved before.
      Step<dim> first = {identity, F - identity, initial_history(law), dt, 2 * dt};
      check_step(first, random);
      const Response<dim> r = evaluate(law, first);
      check_step({F, random.tensor<dim>(0.15), r.history, dt, 3 * dt}, random);
      note_arithmetic();
    }
    check_batches(random);
    check_extremes();
    note_arithmetic();
    bool all = true;
    for (const auto &property : worst)
    {
      all = all && property.second.error <= property.second.allowed;
      if (!(property.second.error <= property.second.allowed))
        std::cout << "    FAILED: " << property.first << ", error " << property.second.error << ", allowed "
                  << property.second.allowed << '\n';
    }
    return all;
  }

private:
  struct Worst
  {
    double error = 0;
    double allowed = 0;
  };

  void note(const std::string &property, const double error, const double allowed)
  {
    Worst &w = worst[property];
    w.allowed = allowed;
    // a NaN must not be lost in a comparison
    if (!(error <= w.error))
      w.error = std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
  }

  /// Numbers that leave the range may vanish again in a minimum or a quotient; the processor remembers them.
  void note_arithmetic()
  {
    note("no overflow, division by zero or undefined number on the way",
         std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW) != 0, 0);
    std::feclearexcept(FE_ALL_EXCEPT);
  }

  static std::vector<Tensor<2, dim>> deformations(RandomNumbers &random)
  {
    const Tensor<2, dim> I = identity;
    Tensor<2, dim> shear = I, compression = I, stretch = I;
    shear[0][1] = 5;
    compression[1][1] = 0.2;
    stretch[0][0] = 3;
    const double isotropic = std::pow(0.2, 1. / dim);
    std::vector<Tensor<2, dim>> result = {I, shear, compression, stretch, isotropic * I};
    for (const double size : {1e-12, 1e-8, 1e-4})
      result.push_back(I + random.tensor<dim>(size));
    const auto Q = random.rotation<dim>(), R = random.rotation<dim>();
    // equal and nearly equal stretches, in turned frames
    for (const Tensor<2, dim> &F :
         {Q, 1.7 * Q, Q * (I + 1e-9 * stretch), Q * stretch * R, Q * compression * R, R * shear})
      result.push_back(F);
    while (result.size() < 30)
    {
      const Tensor<2, dim> F = I + random.tensor<dim>(1.);
      if (determinant(F) > 0.1)
        result.push_back(F);
    }
    return result;
  }

  void check_rest()
  {
    const Step<dim> rest = {identity, {}, initial_history(law)};
    const Response<dim> r = evaluate(law, rest);
    const double E = law.young_modulus(), nu = law.poisson_ratio(), M = law.wave_modulus();
    note("no stress at rest", r.stress.norm() / E, 1e-14);
    note("no stress out of plane at rest", std::abs(r.out_of_plane_stress) / E, 1e-14);
    note("no energy at rest", std::abs(r.energy) / E, 1e-14);
    note("wave modulus is the tangent at rest", std::abs(r.tangent[0][0][0][0] / M - 1), 1e-12);
    note("Poisson's ratio is that of the tangent at rest",
         std::abs(r.tangent[0][0][1][1] / M - nu / (1 - nu)), 1e-12);
    note("Young's modulus fits the wave modulus", std::abs(E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / M - 1),
         1e-12);
    note("one name per history value", law.history_names().size() != law.n_history(), 0);
    note("every point good", r.n_good != 1, 0);
  }

  void check_step(const Step<dim> &step, RandomNumbers &random)
  {
    const Response<dim> r = evaluate(law, step);
    note("every point good", r.n_good != 1, 0);
    note("dissipation is not negative", std::max(0., -r.dissipation) / law.young_modulus(), 0);
    note("only an active law brings in energy", law.is_active() ? 0. : std::abs(r.supply), 0);
    const double scale = r.tangent.norm() + r.stress.norm() + law.young_modulus();

    double asymmetry = 0;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        for (unsigned int k = 0; k < dim; ++k)
          for (unsigned int l = 0; l < dim; ++l)
            asymmetry = std::max(
                {asymmetry,
                 law.symmetric_tangent() ? std::abs(r.tangent[i][j][k][l] - r.tangent[k][l][i][j]) : 0.,
                 std::abs(r.tangent[i][j][k][l] - r.tangent[j][i][k][l]),
                 std::abs(r.tangent[i][j][k][l] - r.tangent[i][j][l][k])});
    note("symmetries of the tangent", asymmetry / scale, 1e-13);

    // All displacement gradients, so that a wrong spin part of the tangent shows too.
    const double h = 1e-5;
    for (unsigned int k = 0; k < dim; ++k)
      for (unsigned int l = 0; l < dim; ++l)
      {
        Tensor<2, dim> L;
        L[k][l] = 1;
        const Response<dim> plus = evaluate(law, perturbed(law, step, h * L));
        const Response<dim> minus = evaluate(law, perturbed(law, step, -h * L));
        const Tensor<2, dim> tau = r.stress;
        Tensor<2, dim> predicted = r.tangent * dealii::symmetrize(L);
        if (finite)
          predicted += L * tau + tau * dealii::transpose(L);
        const Tensor<2, dim> difference = (plus.stress - minus.stress) / (2 * h);
        note("tangent against finite differences", (predicted - difference).norm() / scale, 1e-6);
        const double power = (plus.energy + plus.dissipation - minus.energy - minus.dissipation) / (2 * h);
        note("stress power is the rate of energy", std::abs(power - r.stress * dealii::symmetrize(L)) / scale,
             1e-6);
      }
    check_objectivity(step, r, scale, random);
  }

  void
  check_objectivity(const Step<dim> &step, const Response<dim> &r, const double scale, RandomNumbers &random)
  {
    if (finite)
    {
      const Tensor<2, dim> Q = random.rotation<dim>();
      const Step<dim> turned = {step.F_old, Q * (identity + step.increment) - identity, step.history_old,
                                step.dt, step.time};
      const Response<dim> t = evaluate(law, turned);
      const Tensor<2, dim> expected = Q * r.stress * dealii::transpose(Q);
      note("objectivity of the stress", (Tensor<2, dim>(t.stress) - expected).norm() / scale, 1e-12);
      note("objectivity of the stress out of plane",
           std::abs(t.out_of_plane_stress - r.out_of_plane_stress) / scale, 1e-12);
      note("objectivity of the energy", std::abs(t.energy - r.energy) / scale, 1e-12);
      note("objectivity of the dissipation",
           (std::abs(t.dissipation - r.dissipation) + std::abs(t.supply - r.supply)) / scale, 1e-12);
    }
    else
    {
      const Tensor<2, dim> A = random.tensor<dim>(0.3), spin = A - dealii::transpose(A);
      const Response<dim> before = evaluate(law, {step.F_old, {}, step.history_old, step.dt, step.time});
      const Response<dim> after = evaluate(law, {step.F_old, spin, step.history_old, step.dt, step.time});
      note("spin gives no stress", (after.stress - before.stress).norm() / scale, 1e-14);
    }
  }

  // A batch of many points equals the points one by one, with any choice of outputs, and history in place.
  void check_batches(RandomNumbers &random)
  {
    const unsigned int n = 257, n_history = law.n_history();
    std::vector<Tensor<2, dim>> F(n), increment(n);
    std::vector<double> history(n * n_history), history_new(n * n_history);
    std::vector<SymmetricTensor<2, dim>> stress(n), stress_only(n);
    std::vector<SymmetricTensor<4, dim>> tangent(n);
    std::vector<double> normal(n), energy(n), dissipation(n);
    for (unsigned int q = 0; q < n; ++q)
    {
      increment[q] = random.tensor<dim>(0.2);
      F[q] = identity + increment[q];
      law.initial_history(history.data() + q * n_history);
    }
    const Inputs<dim> in = {n, F.data(), increment.data(), history.data(), dt, dt};
    Outputs<dim> only;
    only.stress = stress_only.data();
    note("every point good", law.update(in, only) != n, 0);
    law.update(in, {stress.data(), tangent.data(), normal.data(), energy.data(), dissipation.data(),
                    history_new.data()});
    const double E = law.young_modulus();
    for (unsigned int q = 0; q < n; ++q)
    {
      const Response<dim> r = evaluate(law, {identity, increment[q], initial_history(law), dt, dt});
      double error = (r.stress - stress[q]).norm() + (r.stress - stress_only[q]).norm() +
                     (r.tangent - tangent[q]).norm() + std::abs(r.energy - energy[q]) +
                     std::abs(r.dissipation - dissipation[q]) +
                     (dim == 2 ? std::abs(r.out_of_plane_stress - normal[q]) : 0.);
      for (unsigned int i = 0; i < n_history; ++i)
        error += E * std::abs(r.history[i] - history_new[q * n_history + i]);
      note("a batch equals its points", error / r.tangent.norm(), 1e-12);
    }
    Outputs<dim> in_place;
    in_place.history_new = history.data();
    law.update(in, in_place);
    note("history may be written in place", history != history_new, 0);

    // One bad point ends the batch there and leaves the rest alone.
    note_arithmetic();
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    for (const double bad : {0., -0.3, nan, inf})
    {
      auto F_bad = F;
      auto increment_bad = increment;
      F_bad[100] = identity;
      F_bad[100][0][0] = bad;
      increment_bad[100] = F_bad[100] - identity;
      std::vector<SymmetricTensor<2, dim>> s(n);
      Outputs<dim> out;
      out.stress = s.data();
      const std::size_t result =
          law.update({n, F_bad.data(), increment_bad.data(), history.data(), dt, dt}, out);
      bool right = result == 100;
      for (unsigned int q = 0; q < n; ++q)
        right = right && (q < 100 ? std::isfinite(s[q].norm()) : s[q].norm() == 0);
      note("the first bad point is reported", !right, 0);
    }
    std::feclearexcept(FE_ALL_EXCEPT); // a NaN that is handed in may raise its flag
  }

  // A volume next to nothing gives numbers, not NaN.
  void check_extremes()
  {
    for (const double tiny : {1e-12, 1e-60, 1e-300})
      for (const unsigned int n_small : {1U, unsigned(dim)})
      {
        Tensor<2, dim> F = identity;
        for (unsigned int i = 0; i < n_small; ++i)
          F[i][i] = n_small == 1 ? tiny : std::pow(tiny, 1. / dim);
        // As F_old, because 1 - 1e-60 is 1 and an increment would lose the volume.
        const Response<dim> r = evaluate(law, {F, {}, initial_history(law), dt, dt});
        note("finite answers at tiny volume",
             r.n_good == 1 && std::isfinite(r.stress.norm() + r.tangent.norm() + r.energy) ? 0 : 1, 0);
      }
  }

  /// Of every step, except at rest [s].
  static constexpr double dt = 0.7;
  inline static const Tensor<2, dim> identity = dealii::unit_symmetric_tensor<dim>();

  const Law<dim> &law;
  const bool finite;
  std::map<std::string, Worst> worst;
};

/// Plane strain is three dimensions without stretch out of plane. @return whether the law says so.
inline bool check_plane_strain(const Law<2> &plane, const Law<3> &space)
{
  RandomNumbers random;
  for (unsigned int n = 0; n < 20; ++n)
  {
    const Tensor<2, 2> L = random.tensor<2>(0.4);
    Tensor<2, 3> L3;
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < 2; ++j)
        L3[i][j] = L[i][j];
    const Response<2> r =
        evaluate(plane, {dealii::unit_symmetric_tensor<2>(), L, initial_history(plane), 0.7, 0.7});
    const Response<3> s =
        evaluate(space, {dealii::unit_symmetric_tensor<3>(), L3, initial_history(space), 0.7, 0.7});
    double error = std::abs(r.out_of_plane_stress - s.stress[2][2]) + std::abs(r.energy - s.energy) +
                   std::abs(r.dissipation - s.dissipation);
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < 2; ++j)
        error += std::abs(r.stress[i][j] - s.stress[i][j]);
    if (!(error < 1e-12 * s.tangent.norm()))
    {
      std::cout << "    FAILED: plane strain equals 3D, error " << error / s.tangent.norm() << '\n';
      return false;
    }
  }
  return true;
}

/// Checks the law @p name in 2D and 3D, over a range of Poisson's ratios. @return whether all properties
/// hold.
inline bool check_law(const std::string &name)
{
  using Settings = std::vector<std::pair<std::string, std::string>>;
  std::vector<Settings> variants = {{}};
  if (dynamic_cast<const constitutive::ElasticLaw<2> *>(make_law<2>(name).get()) != nullptr)
    for (const char *nu : {"-0.5", "0", "0.3", "0.4999"})
      variants.push_back({{"Poisson's ratio", nu}, {"Young's modulus", "3e4"}});
  bool all = true;
  for (const Settings &settings : variants)
  {
    const auto plane = make_law<2>(name, settings);
    const auto space = make_law<3>(name, settings);
    const bool good_2d = LawProperties<2>(*plane).check();
    const bool good_3d = LawProperties<3>(*space).check();
    const bool good_plane = check_plane_strain(*plane, *space);
    if (!good_2d || !good_3d || !good_plane)
    {
      std::cout << "  the lines above: " << name << (good_2d ? "" : " in 2D") << (good_3d ? "" : " in 3D");
      for (const auto &setting : settings)
        std::cout << ", " << setting.first << " = " << setting.second;
      std::cout << '\n';
      all = false;
    }
  }
  return all;
}
} // namespace softgrain::test

#endif
