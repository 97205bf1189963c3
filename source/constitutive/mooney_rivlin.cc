// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/constitutive/deformation.h>
#include <softgrain/constitutive/law_registry.h>
#include <softgrain/constitutive/mooney_rivlin.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>

namespace softgrain::constitutive
{
namespace
{
/// b x b - b box b, the derivative of I1 b - b^2 along the motion.
template <int dim>
dealii::SymmetricTensor<4, dim> second_invariant_modulus(const dealii::SymmetricTensor<2, dim> &b)
{
  dealii::SymmetricTensor<4, dim> c;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = i; j < dim; ++j)
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int l = k; l < dim; ++l)
          c[i][j][k][l] = b[i][j] * b[k][l] - (b[i][k] * b[j][l] + b[i][l] * b[j][k]) / 2;
  return c;
}
} // namespace

template <int dim>
void MooneyRivlin<dim>::declare_parameters(dealii::ParameterHandler &prm) const
{
  ElasticLaw<dim>::declare_parameters(prm);
  prm.declare_entry("Share of the second invariant", "0.2", dealii::Patterns::Double(0., 1.),
                    "C2 / (C1 + C2), the part of the shear modulus that belongs to the second invariant. "
                    "Units: none.");
}

template <int dim>
void MooneyRivlin<dim>::parse_parameters(dealii::ParameterHandler &prm)
{
  ElasticLaw<dim>::parse_parameters(prm);
  share = prm.get_double("Share of the second invariant");
}

template <int dim>
std::size_t MooneyRivlin<dim>::update(const Inputs<dim> &in, const Outputs<dim> &out) const
{
  const double C1 = this->mu * (1 - share) / 2, C2 = this->mu * share / 2, k = this->lambda - 4 * C2;
  for (std::size_t q = 0; q < in.n_points; ++q)
  {
    const dealii::Tensor<2, dim> &F = in.deformation_gradient[q];
    const double J = dealii::determinant(F);
    if (!is_admissible(J))
      return q;
    const dealii::SymmetricTensor<2, dim> b = left_cauchy_green(F);
    // of the whole of b, which in plane strain has a one out of the plane
    const double I1 = dealii::trace(b) + (3 - dim);
    const double pressure = k / 2 * (J - 1) * (J + 1) - 2 * C1 - 4 * C2;
    if (out.stress)
    {
      out.stress[q] = 2 * (C1 + C2 * I1) * b;
      for (unsigned int i = 0; i < dim; ++i)
      {
        out.stress[q][i][i] += pressure;
        for (unsigned int j = i; j < dim; ++j)
          for (unsigned int m = 0; m < dim; ++m)
            out.stress[q][i][j] -= 2 * C2 * b[i][m] * b[m][j];
      }
    }
    if (out.tangent)
      out.tangent[q] =
          isotropic_modulus<dim>(k * J * J, -pressure) + 4 * C2 * second_invariant_modulus<dim>(b);
    if (dim == 2 && out.out_of_plane_stress)
      out.out_of_plane_stress[q] = 2 * C1 + 2 * C2 * (I1 - 1) + pressure;
    if (out.energy)
    {
      const double I2 = dealii::second_invariant(b) + (dim == 2 ? dealii::trace(b) : 0.);
      out.energy[q] = C1 * (I1 - 3) + C2 * (I2 - 3) + k / 4 * (J - 1) * (J + 1) -
                      (this->lambda / 2 + this->mu) * std::log(J);
    }
    if (out.dissipation)
      out.dissipation[q] = 0;
  }
  return in.n_points;
}

template class MooneyRivlin<2>;
template class MooneyRivlin<3>;

namespace
{
[[maybe_unused]] const bool registered = register_law<MooneyRivlin>(
    "mooney_rivlin",
    "Rubber with both invariants; in plane strain only the stress out of plane differs from neo-Hookean.");
}
} // namespace softgrain::constitutive
