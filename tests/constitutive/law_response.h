// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_constitutive_law_response_h
#define softgrain_tests_constitutive_law_response_h

#include <softgrain/constitutive/law_registry.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <random>
#include <string>
#include <vector>

namespace softgrain::test
{
using constitutive::Inputs;
using constitutive::Kinematics;
using constitutive::Law;
using constitutive::Outputs;
using dealii::SymmetricTensor;
using dealii::Tensor;

/// A law with the given settings ("Poisson's ratio", "0.3"), as a program would make it.
template <int dim>
std::unique_ptr<Law<dim>> make_law(const std::string &name,
                                   const std::vector<std::pair<std::string, std::string>> &settings = {})
{
  dealii::ParameterHandler prm;
  constitutive::declare_all_laws(prm);
  prm.enter_subsection(Registry<Law<dim>>::instance().create(name)->title());
  for (const auto &setting : settings)
    prm.set(setting.first, setting.second);
  prm.leave_subsection();
  return constitutive::create_law<dim>(name, prm);
}

/// A step of one point: where it was, and what happened to it.
template <int dim>
struct Step
{
  Tensor<2, dim> F_old;
  Tensor<2, dim> increment;
  std::vector<double> history_old;
  double dt = 0;   ///< length [s]
  double time = 0; ///< at its end [s]

  Tensor<2, dim> F() const { return (dealii::unit_symmetric_tensor<dim>() + increment) * F_old; }
};

/// Everything that a law says about one point.
template <int dim>
struct Response
{
  SymmetricTensor<2, dim> stress;
  SymmetricTensor<4, dim> tangent;
  double out_of_plane_stress = 0;
  double energy = 0;
  double dissipation = 0;
  double supply = 0;
  std::vector<double> history;
  std::size_t n_good = 0;
};

template <int dim>
std::vector<double> initial_history(const Law<dim> &law)
{
  std::vector<double> history(law.n_history());
  law.initial_history(history.data());
  return history;
}

template <int dim>
Response<dim> evaluate(const Law<dim> &law, const Step<dim> &step)
{
  Response<dim> r;
  r.history.resize(law.n_history());
  const Tensor<2, dim> F = step.F();
  // A law of one kinematics must not read what belongs to the other.
  const bool finite = law.kinematics() == Kinematics::finite_strain;
  const Inputs<dim> in = {
      1,        finite ? &F : nullptr, finite ? nullptr : &step.increment, step.history_old.data(), step.dt,
      step.time};
  Outputs<dim> out = {&r.stress, &r.tangent,     &r.out_of_plane_stress,
                      &r.energy, &r.dissipation, r.history.data()};
  out.supply = &r.supply;
  r.n_good = law.update(in, out);
  return r;
}

/// The same step with a further displacement gradient @p L on top of it.
template <int dim>
Step<dim> perturbed(const Law<dim> &law, const Step<dim> &step, const Tensor<2, dim> &L)
{
  Step<dim> result = step;
  result.increment += law.kinematics() == Kinematics::small_strain
                          ? L
                          : L * (dealii::unit_symmetric_tensor<dim>() + step.increment);
  return result;
}

/// Numbers in [-1, 1] that are the same with every standard library.
class RandomNumbers
{
public:
  double operator()() { return 2. * generator() / std::mt19937::max() - 1; }

  template <int dim>
  Tensor<2, dim> tensor(const double size)
  {
    Tensor<2, dim> result;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        result[i][j] = size * (*this)();
    return result;
  }

  /// A rotation: Gram-Schmidt of a random matrix, orientation repaired by the sign of the last row.
  template <int dim>
  Tensor<2, dim> rotation()
  {
    Tensor<2, dim> Q;
    do
      Q = tensor<dim>(1);
    while (std::abs(determinant(Q)) < 0.1);
    for (unsigned int i = 0; i < dim; ++i)
    {
      for (unsigned int j = 0; j < i; ++j)
        Q[i] -= (Q[i] * Q[j]) * Q[j];
      Q[i] /= Q[i].norm();
    }
    if (determinant(Q) < 0)
      Q[dim - 1] *= -1;
    return Q;
  }

private:
  std::mt19937 generator{1};
};
} // namespace softgrain::test

#endif
