// SPDX-License-Identifier: LGPL-2.1-or-later
// A solid that stiffens exponentially (Fung), with g = I1 - 3 - 2 ln J >= 0 and k >= 0 (k = 0: neo-Hookean):
//   psi = mu/(2 k) (exp(k g) - 1) + lambda/2 (ln J)^2,   tau = mu exp(k g) (b - I) + lambda ln J I,
//   c   = 2 mu k exp(k g) (b - I) x (b - I) + lambda I x I + 2 (mu exp(k g) - lambda ln J) II_s.
#include <softgrain/constitutive/deformation.h>
#include <softgrain/constitutive/elastic_law.h>
#include <softgrain/constitutive/law_registry.h>

#include <deal.II/base/parameter_handler.h>

using namespace softgrain::constitutive;

template <int dim>
class Fung final : public ElasticLaw<dim> // which brings E, nu, lambda, mu and the wave modulus
{
public:
  std::string title() const override { return "Fung"; }

  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    ElasticLaw<dim>::declare_parameters(prm);
    prm.declare_entry("Stiffening", "0.1", dealii::Patterns::Double(0.), "Exponent k. Units: none.");
  }

  void parse_parameters(dealii::ParameterHandler &prm) override
  {
    ElasticLaw<dim>::parse_parameters(prm);
    k = prm.get_double("Stiffening");
  }

  std::size_t update(const Inputs<dim> &in, const Outputs<dim> &out) const override
  {
    const double lambda = this->lambda, mu = this->mu;
    const dealii::SymmetricTensor<2, dim> I = dealii::unit_symmetric_tensor<dim>();
    for (std::size_t q = 0; q < in.n_points; ++q)
    {
      const double J = dealii::determinant(in.deformation_gradient[q]);
      const double log_J = std::log(is_admissible(J) ? J : 1.);
      const dealii::SymmetricTensor<2, dim> b_I = left_cauchy_green(in.deformation_gradient[q]) - I;
      const double g = dealii::trace(b_I) - 2 * log_J, growth = std::exp(k * g);
      if (!is_admissible(J) || !std::isfinite(growth))
        return q;
      if (out.stress)
        out.stress[q] = mu * growth * b_I + lambda * log_J * I;
      if (out.tangent)
        out.tangent[q] = 2 * mu * k * growth * dealii::outer_product(b_I, b_I) +
                         isotropic_modulus<dim>(lambda, mu * growth - lambda * log_J);
      if (dim == 2 && out.out_of_plane_stress)
        out.out_of_plane_stress[q] = lambda * log_J;
      if (out.energy)
        out.energy[q] = mu / 2 * (k > 0 ? std::expm1(k * g) / k : g) + lambda / 2 * log_J * log_J;
      if (out.dissipation)
        out.dissipation[q] = 0;
    }
    return in.n_points;
  }

private:
  double k = 0.1;
};

[[maybe_unused]] const bool registered = register_law<Fung>("fung", "Solid that stiffens exponentially.");
