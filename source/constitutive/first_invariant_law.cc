// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/constitutive/deformation.h>
#include <softgrain/constitutive/first_invariant_law.h>

#include <cmath>

namespace softgrain::constitutive
{
template <int dim>
double FirstInvariantLaw<dim>::limit() const
{
  return std::numeric_limits<double>::infinity();
}

template <int dim>
void FirstInvariantLaw<dim>::check_volume(const std::string &cause) const
{
  if (!(this->lambda / 2 + this->mu * (1 - shape(0.).curvature) > 0))
    throw InputError(cause +
                     " is not allowed with this Poisson's ratio: the solid would collapse under pressure");
}

template <int dim>
std::size_t FirstInvariantLaw<dim>::update(const Inputs<dim> &in, const Outputs<dim> &out) const
{
  const double largest = limit(), k = this->lambda - 2 * this->mu * shape(0.).curvature;
  for (std::size_t q = 0; q < in.n_points; ++q)
  {
    const dealii::Tensor<2, dim> &F = in.deformation_gradient[q];
    const double J = dealii::determinant(F), x = F.norm_square() - dim;
    if (!is_admissible(J) || !(x < largest))
      return q;
    const double pressure = k / 2 * (J - 1) * (J + 1) - this->mu;
    const Shape s = shape(x);
    const dealii::SymmetricTensor<2, dim> b = left_cauchy_green(F);
    if (out.stress)
    {
      out.stress[q] = this->mu * s.slope * b;
      for (unsigned int i = 0; i < dim; ++i)
        out.stress[q][i][i] += pressure;
    }
    if (out.tangent)
      out.tangent[q] = isotropic_modulus<dim>(k * J * J, -pressure) +
                       dealii::outer_product(2 * this->mu * s.curvature * b, b);
    if (dim == 2 && out.out_of_plane_stress)
      out.out_of_plane_stress[q] = this->mu * s.slope + pressure;
    if (out.energy)
      out.energy[q] = this->mu / 2 * s.value + k / 4 * (J - 1) * (J + 1) - (k / 2 + this->mu) * std::log(J);
    if (out.dissipation)
      out.dissipation[q] = 0;
  }
  return in.n_points;
}

template class FirstInvariantLaw<2>;
template class FirstInvariantLaw<3>;
} // namespace softgrain::constitutive
