// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/constitutive/deformation.h>
#include <softgrain/constitutive/hencky.h>
#include <softgrain/constitutive/law_registry.h>
#include <softgrain/constitutive/spectral_modulus.h>

namespace softgrain::constitutive
{
template <int dim>
std::size_t Hencky<dim>::update(const Inputs<dim> &in, const Outputs<dim> &out) const
{
  for (std::size_t q = 0; q < in.n_points; ++q)
  {
    const dealii::Tensor<2, dim> &F = in.deformation_gradient[q];
    const double J = dealii::determinant(F);
    if (!is_admissible(J))
      return q;
    const PrincipalStretches<dim> stretches = principal_stretches(F, J);
    double log_J = 0, sum_of_squares = 0;
    for (const double strain : stretches.log)
    {
      log_J += strain;
      sum_of_squares += strain * strain;
    }
    std::array<double, dim> tau;
    for (unsigned int a = 0; a < dim; ++a)
      tau[a] = 2 * this->mu * stretches.log[a] + this->lambda * log_J;

    if (out.stress)
      out.stress[q] = spectral_tensor<dim>(tau, stretches);
    if (out.tangent)
    {
      SpectralModulus<dim> modulus;
      for (unsigned int a = 0; a < dim; ++a)
        for (unsigned int b = 0; b < dim; ++b)
        {
          modulus.normal[a][b] = this->lambda + (a == b ? 2 * (this->mu - tau[a]) : 0.);
          // g_ab with e = ln(b_a / b_b) <= 0: (tau_a - tau_b) / (b_a / b_b - 1) - tau_b, tau_a - tau_b = mu e
          const bool ordered = stretches.log[a] <= stretches.log[b];
          const double e = -2 * std::abs(stretches.log[a] - stretches.log[b]);
          modulus.shear[a][b] = this->mu * (e < 0 ? e / std::expm1(e) : 1.) - tau[ordered ? b : a];
        }
      out.tangent[q] = modulus.rotated_to(stretches);
    }
    if (dim == 2 && out.out_of_plane_stress)
      out.out_of_plane_stress[q] = this->lambda * log_J;
    if (out.energy)
      out.energy[q] = this->mu * sum_of_squares + this->lambda / 2 * log_J * log_J;
    if (out.dissipation)
      out.dissipation[q] = 0;
  }
  return in.n_points;
}

template class Hencky<2>;
template class Hencky<3>;

namespace
{
[[maybe_unused]] const bool registered = register_law<Hencky>(
    "hencky",
    "Linear elasticity in logarithmic strain, for moderate strains; symmetric in tension and compression.");
}
} // namespace softgrain::constitutive
