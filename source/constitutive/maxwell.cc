// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/constitutive/deformation.h>
#include <softgrain/constitutive/law_registry.h>
#include <softgrain/constitutive/logarithmic_strain.h>
#include <softgrain/constitutive/maxwell.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <cmath>
#include <numeric>

namespace softgrain::constitutive
{
template <int dim>
void Maxwell<dim>::declare_parameters(dealii::ParameterHandler &prm) const
{
  using namespace dealii::Patterns;
  ElasticLaw<dim>::declare_parameters(prm);
  prm.declare_entry("Shares", "0.5", List(Double(0.), 1, 10),
                    "Parts of the modulus at once that relax, one per relaxation time, of sum 1 at most. "
                    "Units: none.");
  prm.declare_entry("Relaxation times", "1", List(Double(0.), 1, 10), "One per share, above 0. Units: s.");
}

template <int dim>
void Maxwell<dim>::parse_parameters(dealii::ParameterHandler &prm)
{
  ElasticLaw<dim>::parse_parameters(prm);
  const auto numbers = [&prm](const std::string &name)
  { return dealii::Utilities::string_to_double(dealii::Utilities::split_string_list(prm.get(name))); };
  shares = numbers("Shares");
  times = numbers("Relaxation times");
  if (shares.size() != times.size())
    throw InputError("Relaxation times = " + prm.get("Relaxation times") + " is not allowed with Shares = " +
                     prm.get("Shares") + ": there must be one time per share");
  for (const double time : times)
    if (!(time > 0))
      throw InputError("Relaxation times = " + prm.get("Relaxation times") +
                       " is not allowed; each must be above 0");
  if (std::accumulate(shares.begin(), shares.end(), 0.) > 1 + 1e-12)
    throw InputError("Shares = " + prm.get("Shares") + " is not allowed; their sum must not be above 1");
}

template <int dim>
void Maxwell<dim>::initial_history(double *history) const
{
  std::fill(history, history + n_history(), 0.);
  for (unsigned int k = 0; k < times.size(); ++k)
    for (unsigned int i = 0; i < dim; ++i)
      history[k * n_of_branch + i * (dim + 1)] = 1;
}

template <int dim>
std::vector<std::string> Maxwell<dim>::history_names() const
{
  const std::vector<std::string> components =
      dim == 2 ? std::vector<std::string>{"xx", "yy", "xy"}
               : std::vector<std::string>{"xx", "yy", "zz", "xy", "xz", "yz"};
  const std::string axes = "xyz";
  std::vector<std::string> names;
  for (unsigned int k = 1; k <= times.size(); ++k)
  {
    const std::string branch = "branch_" + std::to_string(k) + "_";
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        names.push_back(branch + "inverse_viscous_" + axes[i] + axes[j]);
    for (const std::string &component : components)
      names.push_back(branch + "elastic_strain_" + component);
  }
  return names;
}

template <int dim>
std::size_t Maxwell<dim>::update(const Inputs<dim> &in, const Outputs<dim> &out) const
{
  using Strain = dealii::SymmetricTensor<2, dim>;
  constexpr unsigned int n = Strain::n_independent_components, n_viscous = dim * dim;
  const double lambda = this->lambda, mu = this->mu;
  const Strain one = dealii::unit_symmetric_tensor<dim>();
  const auto product = [&](const Strain &a, const Strain &b)
  { return 2 * mu * (a * b) + lambda * dealii::trace(a) * dealii::trace(b); };
  std::vector<double> kept, followed; // r and s of the branches
  for (const double time : times)
  {
    const double x = in.dt / time;
    kept.push_back(std::exp(-x));
    followed.push_back(x > 0 ? -std::expm1(-x) / x : 1.);
  }
  const double lasting = 1 - std::accumulate(shares.begin(), shares.end(), 0.);
  for (std::size_t q = 0; q < in.n_points; ++q)
  {
    const dealii::Tensor<2, dim> &F = in.deformation_gradient[q];
    const double J = dealii::determinant(F), *old = in.history_old + q * n_history();
    if (!is_admissible(J))
      return q;
    dealii::SymmetricTensor<2, dim> stress;
    dealii::SymmetricTensor<4, dim> tangent;
    double zz = 0, energy = 0, dissipation = 0;
    const auto inverse_viscous = [&](const unsigned int k)
    {
      dealii::Tensor<2, dim> G;
      for (unsigned int i = 0; i < n_viscous; ++i)
        G[i / dim][i % dim] = old[k * n_of_branch + i];
      return G;
    };
    for (unsigned int k = 0; k < times.size(); ++k)
      if (!is_admissible(J * dealii::determinant(inverse_viscous(k))))
        return q;
    const auto add =
        [&](const LogarithmicStrain<dim> &strain, const Strain &E, const double share, const double slope)
    {
      const Strain T = share * (2 * mu * E + lambda * dealii::trace(E) * one);
      stress += strain.stress(T);
      if (out.tangent)
        tangent += strain.modulus(T, isotropic_modulus<dim>(share * slope * lambda, share * slope * mu));
      zz += share * lambda * dealii::trace(E);
      energy += share / 2 * product(E, E);
    };
    const LogarithmicStrain<dim> whole(F, J);
    add(whole, whole.strain, lasting, 1.);
    for (unsigned int k = 0; k < times.size(); ++k)
    {
      const double r = kept[k], s = followed[k];
      dealii::Tensor<2, dim> G = inverse_viscous(k);
      Strain E_old;
      for (unsigned int i = 0; i < n; ++i)
        E_old.access_raw_entry(i) = old[k * n_of_branch + n_viscous + i];
      const LogarithmicStrain<dim> trial(F * G, J * dealii::determinant(G));
      const Strain E = s * trial.strain + (r - s) * E_old;
      add(trial, E, shares[k], s);
      // Rest of the potential of the stress; without motion it is what relaxes.
      dissipation +=
          shares[k] *
          std::max(0., s / 2 * product(trial.strain, trial.strain) + (r - s) * product(trial.strain, E_old) +
                           (0.5 - r + s / 2) * product(E_old, E_old) - product(E, E) / 2);
      if (!out.history_new)
        continue;
      G = trial.relaxed(G, trial.strain - E);
      double *fresh = out.history_new + q * n_history() + k * n_of_branch;
      for (unsigned int i = 0; i < n_viscous; ++i)
        fresh[i] = G[i / dim][i % dim];
      for (unsigned int i = 0; i < n; ++i)
        fresh[n_viscous + i] = E.access_raw_entry(i);
    }
    if (out.stress)
      out.stress[q] = stress;
    if (out.tangent)
      out.tangent[q] = tangent;
    if (dim == 2 && out.out_of_plane_stress)
      out.out_of_plane_stress[q] = zz;
    if (out.energy)
      out.energy[q] = energy;
    if (out.dissipation)
      out.dissipation[q] = dissipation;
  }
  return in.n_points;
}

template class Maxwell<2>;
template class Maxwell<3>;

namespace
{
[[maybe_unused]] const bool registered =
    register_law<Maxwell>("maxwell", "Viscoelastic solid: springs behind dashpots, at finite strain.");
}
} // namespace softgrain::constitutive
