// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/constitutive/deformation.h>
#include <softgrain/constitutive/law_registry.h>
#include <softgrain/constitutive/linear_elastic.h>

namespace softgrain::constitutive
{
template <int dim>
std::vector<std::string> LinearElastic<dim>::history_names() const
{
  // deal.II's order of the entries of a symmetric tensor
  if (dim == 2)
    return {"strain_xx", "strain_yy", "strain_xy"};
  return {"strain_xx", "strain_yy", "strain_zz", "strain_xy", "strain_xz", "strain_yz"};
}

template <int dim>
std::size_t LinearElastic<dim>::update(const Inputs<dim> &in, const Outputs<dim> &out) const
{
  constexpr unsigned int n = dealii::SymmetricTensor<2, dim>::n_independent_components;
  const dealii::SymmetricTensor<4, dim> C = isotropic_modulus<dim>(this->lambda, this->mu);
  for (std::size_t q = 0; q < in.n_points; ++q)
  {
    if (!is_admissible(dealii::determinant(dealii::unit_symmetric_tensor<dim>() + in.increment[q])))
      return q;
    dealii::SymmetricTensor<2, dim> strain = dealii::symmetrize(in.increment[q]);
    for (unsigned int i = 0; i < n; ++i)
      strain.access_raw_entry(i) += in.history_old[n * q + i];
    dealii::SymmetricTensor<2, dim> sigma = 2 * this->mu * strain;
    for (unsigned int i = 0; i < dim; ++i)
      sigma[i][i] += this->lambda * dealii::trace(strain);
    if (out.stress)
      out.stress[q] = sigma;
    if (out.tangent)
      out.tangent[q] = C;
    if (dim == 2 && out.out_of_plane_stress)
      out.out_of_plane_stress[q] = this->lambda * dealii::trace(strain);
    if (out.energy)
      out.energy[q] = (sigma * strain) / 2;
    if (out.dissipation)
      out.dissipation[q] = 0;
    if (out.history_new)
      for (unsigned int i = 0; i < n; ++i)
        out.history_new[n * q + i] = strain.access_raw_entry(i);
  }
  return in.n_points;
}

template class LinearElastic<2>;
template class LinearElastic<3>;

namespace
{
[[maybe_unused]] const bool registered = register_law<LinearElastic>(
    "linear_elastic",
    "The thesis's law (3.5): linear elasticity in accumulated small strain; no large rotations.");
}
} // namespace softgrain::constitutive
