// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/constitutive/deformation.h>
#include <softgrain/constitutive/j2_plastic.h>
#include <softgrain/constitutive/law_registry.h>
#include <softgrain/constitutive/logarithmic_strain.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>

namespace softgrain::constitutive
{
template <int dim>
void J2Plastic<dim>::declare_parameters(dealii::ParameterHandler &prm) const
{
  using dealii::Patterns::Double;
  ElasticLaw<dim>::declare_parameters(prm);
  prm.declare_entry("Yield stress", "1e6", Double(0.),
                    "S_y in uniaxial tension at first yield, above 0. Units: Pa.");
  prm.declare_entry("Hardening modulus", "0", Double(0.),
                    "H, rise of the yield stress per equivalent plastic strain. Units: Pa.");
  prm.declare_entry("Saturation stress", "1e6", Double(0.),
                    "S_inf, the yield stress that Voce hardening tends to, not below the yield stress; read "
                    "where the saturation rate is above 0. Units: Pa.");
  prm.declare_entry("Saturation rate", "0", Double(0.),
                    "delta of Voce hardening; 0 is without. Units: none.");
  prm.declare_entry(
      "Kinematic modulus", "0", Double(0.),
      "H_k, rise of the back stress per equivalent plastic strain in uniaxial tension. Units: Pa.");
}

template <int dim>
void J2Plastic<dim>::parse_parameters(dealii::ParameterHandler &prm)
{
  ElasticLaw<dim>::parse_parameters(prm);
  yield = prm.get_double("Yield stress");
  linear = prm.get_double("Hardening modulus");
  saturation = prm.get_double("Saturation stress");
  rate = prm.get_double("Saturation rate");
  kinematic = prm.get_double("Kinematic modulus");
  check_yield(prm);
  if (rate > 0 && saturation < yield)
    throw InputError("Saturation stress = " + prm.get("Saturation stress") +
                     " Pa is not allowed; it must not be below Yield stress = " + prm.get("Yield stress") +
                     " Pa, because a solid that softens has no answer that is independent of the mesh");
}

template <int dim>
void J2Plastic<dim>::check_yield(dealii::ParameterHandler &prm) const
{
  if (!(yield > 0))
    throw InputError("Yield stress = " + prm.get("Yield stress") + " Pa is not allowed; it must be above 0");
}

template <int dim>
void J2Plastic<dim>::initial_history(double *history) const
{
  std::fill(history, history + n_history(), 0.);
  for (unsigned int i = 0; i < dim; ++i)
    history[i * (dim + 1)] = 1;
}

template <int dim>
std::vector<std::string> J2Plastic<dim>::history_names() const
{
  const std::vector<std::string> components =
      dim == 2 ? std::vector<std::string>{"xx", "yy", "xy"}
               : std::vector<std::string>{"xx", "yy", "zz", "xy", "xz", "yz"};
  const std::string axes = "xyz";
  std::vector<std::string> names;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = 0; j < dim; ++j)
      names.push_back(std::string("inverse_plastic_") + axes[i] + axes[j]);
  for (const std::string &component : components)
    names.push_back("plastic_strain_" + component);
  names.push_back("equivalent_plastic_strain");
  return names;
}

template <int dim>
double J2Plastic<dim>::yield_stress(const double alpha) const
{
  return yield + linear * alpha - (rate > 0 ? (saturation - yield) * std::expm1(-rate * alpha) : 0.);
}

template <int dim>
double J2Plastic<dim>::hardening(const double alpha) const
{
  return linear + (rate > 0 ? (saturation - yield) * rate * std::exp(-rate * alpha) : 0.);
}

template <int dim>
double J2Plastic<dim>::plastic_work(const double alpha) const
{
  return alpha * (yield + linear / 2 * alpha) +
         (rate > 0 ? (saturation - yield) * (alpha + std::expm1(-rate * alpha) / rate) : 0.);
}

template <int dim>
typename J2Plastic<dim>::Flow
J2Plastic<dim>::flow(const double trial, const double alpha_old, const double, const double) const
{
  if (!(trial > yield_stress(alpha_old)))
    return {};
  // What is left over is convex and falls, so that Newton's method comes from the left without overshooting.
  const double elastic = 3 * this->mu + kinematic;
  double increment = 0;
  for (unsigned int i = 0; i < 50; ++i)
  {
    const double alpha = alpha_old + increment;
    const double step = (trial - elastic * increment - yield_stress(alpha)) / (elastic + hardening(alpha));
    increment += step;
    if (std::abs(step) <= 1e-14 * increment)
      break;
  }
  const double alpha = alpha_old + increment;
  return {increment, 1 / (elastic + hardening(alpha)),
          std::max(0., plastic_work(alpha) - plastic_work(alpha_old))};
}

template <int dim>
std::size_t J2Plastic<dim>::update(const Inputs<dim> &in, const Outputs<dim> &out) const
{
  using Strain = dealii::SymmetricTensor<2, dim>;
  constexpr unsigned int n = Strain::n_independent_components, n_strain = dim * dim, n_own = n_strain + n + 1;
  const unsigned int n_row = n_history();
  const double mu = this->mu, bulk = this->lambda + 2. / 3. * mu;
  for (std::size_t q = 0; q < in.n_points; ++q)
  {
    const dealii::Tensor<2, dim> &F = in.deformation_gradient[q];
    const double J = dealii::determinant(F);
    if (!is_admissible(J))
      return q;
    const double *old = in.history_old + q * n_row;
    dealii::Tensor<2, dim> G;
    for (unsigned int i = 0; i < n_strain; ++i)
      G[i / dim][i % dim] = old[i];
    Strain A;
    for (unsigned int i = 0; i < n; ++i)
      A.access_raw_entry(i) = old[n_strain + i];
    const double alpha_old = old[n_strain + n], det_G = dealii::determinant(G);
    if (!is_admissible(J * det_G))
      return q;

    const LogarithmicStrain<dim> trial(F * G, J * det_G);
    // det Fp = 1: what is missing in the plane is stretch out of it
    const double log_J = std::log(J), zz = dim == 2 ? -std::log(det_G) : 0.;
    Strain s = 2 * mu * trial.strain; // the deviator
    for (unsigned int i = 0; i < dim; ++i)
      s[i][i] -= 2 * mu / 3 * log_J;
    const double s_zz = 2 * mu * (zz - log_J / 3);
    Strain xi = s - 2. / 3. * kinematic * A;
    double A_zz = dim == 2 ? -dealii::trace(A) : 0.;
    const double xi_zz = dim == 2 ? s_zz - 2. / 3. * kinematic * A_zz : 0.;
    const double size = std::sqrt(xi * xi + xi_zz * xi_zz), equivalent = std::sqrt(1.5) * size;
    const Flow flow = this->flow(equivalent, alpha_old, n_row > n_own ? old[n_own] : 0., in.dt);
    const bool flows = flow.increment > 0;
    const double per_size = flows ? std::sqrt(1.5) * flow.increment / size : 0.; // D = per_size xi
    const Strain D = per_size * xi;
    A += D;
    A_zz += per_size * xi_zz;
    Strain T = s - 2 * mu * D;
    const double mean = bulk * log_J;
    for (unsigned int i = 0; i < dim; ++i)
      T[i][i] += mean;
    const double s_zz_new = s_zz - 2 * mu * per_size * xi_zz;

    if (out.stress)
      out.stress[q] = trial.stress(T);
    if (out.tangent)
    {
      // dT/dE: the elastic modulus less 2 mu dD/dE
      const double shear = mu * (1 - 2 * mu * per_size);
      dealii::SymmetricTensor<4, dim> modulus = isotropic_modulus<dim>(bulk - 2. / 3. * shear, shear);
      if (flows)
        modulus -=
            dealii::outer_product(4 * mu * mu * (1.5 * flow.softness - per_size) / (size * size) * xi, xi);
      out.tangent[q] = trial.modulus(T, modulus);
    }
    if (dim == 2 && out.out_of_plane_stress)
      out.out_of_plane_stress[q] = mean + s_zz_new;
    if (out.energy)
    {
      Strain deviator = s - 2 * mu * D;
      const double elastic = deviator * deviator + (dim == 2 ? s_zz_new * s_zz_new : 0.);
      out.energy[q] = elastic / (4 * mu) + mean * log_J / 2 + kinematic / 3 * (A * A + A_zz * A_zz);
    }
    if (out.dissipation)
      out.dissipation[q] = flow.dissipation;
    if (out.step_share && largest_increment > 0 && flow.increment > largest_increment)
      *out.step_share = std::min(*out.step_share, largest_increment / flow.increment);
    if (out.history_new)
    {
      if (flows)
        G = trial.relaxed(G, D);
      double *fresh = out.history_new + q * n_row;
      for (unsigned int i = 0; i < n_strain; ++i)
        fresh[i] = G[i / dim][i % dim];
      for (unsigned int i = 0; i < n; ++i)
        fresh[n_strain + i] = A.access_raw_entry(i);
      fresh[n_strain + n] = alpha_old + flow.increment;
      if (n_row > n_own)
        fresh[n_own] = flow.rate;
    }
  }
  return in.n_points;
}

template class J2Plastic<2>;
template class J2Plastic<3>;

namespace
{
[[maybe_unused]] const bool registered = register_law<J2Plastic>(
    "j2_plastic",
    "Metal-like solid: von Mises plasticity at finite strain with isotropic and kinematic hardening.");
}
} // namespace softgrain::constitutive
