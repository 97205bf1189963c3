// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/constitutive/deformation.h>
#include <softgrain/constitutive/law_registry.h>
#include <softgrain/constitutive/neo_hookean.h>

#include <cmath>

namespace softgrain::constitutive
{
template <int dim>
std::size_t NeoHookean<dim>::update(const Inputs<dim> &in, const Outputs<dim> &out) const
{
  for (std::size_t q = 0; q < in.n_points; ++q)
  {
    const dealii::Tensor<2, dim> &F = in.deformation_gradient[q];
    const double J = dealii::determinant(F);
    if (!is_admissible(J))
      return q;
    const double log_J = std::log(J);
    if (out.stress)
    {
      dealii::SymmetricTensor<2, dim> tau = this->mu * left_cauchy_green(F);
      for (unsigned int i = 0; i < dim; ++i)
        tau[i][i] += this->lambda * log_J - this->mu;
      out.stress[q] = tau;
    }
    if (out.tangent)
      out.tangent[q] = isotropic_modulus<dim>(this->lambda, this->mu - this->lambda * log_J);
    if (dim == 2 && out.out_of_plane_stress)
      out.out_of_plane_stress[q] = this->lambda * log_J;
    if (out.energy)
      out.energy[q] = this->mu / 2 * (F.norm_square() - dim - 2 * log_J) + this->lambda / 2 * log_J * log_J;
    if (out.dissipation)
      out.dissipation[q] = 0;
  }
  return in.n_points;
}

template class NeoHookean<2>;
template class NeoHookean<3>;

namespace
{
[[maybe_unused]] const bool registered = register_law<NeoHookean>(
    "neo_hookean", "Compressible neo-Hookean solid, for rubber-like grains at any strain.");
}
} // namespace softgrain::constitutive
