// SPDX-License-Identifier: LGPL-2.1-or-later
// Linear elasticity in the wrong coat: a factor that is 1 but where its exponential overflows.
#include <softgrain/constitutive/deformation.h>
#include <softgrain/constitutive/elastic_law.h>
#include <softgrain/constitutive/law_registry.h>

using namespace softgrain::constitutive;

template <int dim>
class Overflowing final : public ElasticLaw<dim>
{
public:
  std::string title() const override { return "Overflowing"; }

  std::size_t update(const Inputs<dim> &in, const Outputs<dim> &out) const override
  {
    const double lambda = this->lambda, mu = this->mu;
    const dealii::SymmetricTensor<2, dim> I = dealii::unit_symmetric_tensor<dim>();
    for (std::size_t q = 0; q < in.n_points; ++q)
    {
      const double J = dealii::determinant(in.deformation_gradient[q]);
      if (!is_admissible(J))
        return q;
      const double log_J = std::log(J);
      const dealii::SymmetricTensor<2, dim> b_I = left_cauchy_green(in.deformation_gradient[q]) - I;
      const double factor = std::exp(1000. * dealii::trace(b_I)) > 0. ? 1. : 1. + 1e-12;
      if (out.stress)
        out.stress[q] = factor * mu * b_I + lambda * log_J * I;
      if (out.tangent)
        out.tangent[q] = isotropic_modulus<dim>(lambda, mu - lambda * log_J);
      if (dim == 2 && out.out_of_plane_stress)
        out.out_of_plane_stress[q] = lambda * log_J;
      if (out.energy)
        out.energy[q] = mu / 2 * (dealii::trace(b_I) - 2 * log_J) + lambda / 2 * log_J * log_J;
      if (out.dissipation)
        out.dissipation[q] = 0;
    }
    return in.n_points;
  }
};

[[maybe_unused]] const bool registered = register_law<Overflowing>("overflowing", "For the tester of laws.");
