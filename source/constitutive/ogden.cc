// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/constitutive/deformation.h>
#include <softgrain/constitutive/law_registry.h>
#include <softgrain/constitutive/ogden.h>
#include <softgrain/constitutive/spectral_modulus.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <numeric>
#include <sstream>

namespace softgrain::constitutive
{
namespace
{
// Powers up to e^250 leave room for squares of stresses in Pa below the largest double, e^709.
constexpr double largest_power = 250;

/// (small^alpha - large^alpha) / (small^2 / large^2 - 1) of two stretches given by their logarithms.
double power_slope(const double alpha, const double log_1, const double log_2)
{
  const double large = std::max(log_1, log_2), small = std::min(log_1, log_2), e = small - large;
  if (!(e < 0))
    return alpha / 2 * std::exp(alpha * large);
  // from the side on which the exponential stays small
  return (alpha > 0 ? std::exp(alpha * large) * std::expm1(alpha * e)
                    : -std::exp(alpha * small) * std::expm1(-alpha * e)) /
         std::expm1(2 * e);
}
} // namespace

template <int dim>
void Ogden<dim>::declare_parameters(dealii::ParameterHandler &prm) const
{
  using namespace dealii::Patterns;
  ElasticLaw<dim>::declare_parameters(prm);
  prm.declare_entry("Exponents", "1.3, 5", List(Double(-20., 20.), 1, 10),
                    "Powers alpha_p of the principal stretches, none of them 0. Units: none.");
  prm.declare_entry("Weights", "0.99, 0.01", List(Double(0.), 1, 10),
                    "One per exponent, above 0: parts of the shear modulus in proportion to these numbers. "
                    "Units: none.");
}

template <int dim>
void Ogden<dim>::parse_parameters(dealii::ParameterHandler &prm)
{
  ElasticLaw<dim>::parse_parameters(prm);
  const auto numbers = [&prm](const std::string &name)
  { return dealii::Utilities::string_to_double(dealii::Utilities::split_string_list(prm.get(name))); };
  exponents = numbers("Exponents");
  shares = numbers("Weights");
  if (shares.size() != exponents.size())
    throw InputError("Weights = " + prm.get("Weights") + " is not allowed with Exponents = " +
                     prm.get("Exponents") + ": there must be one weight per exponent");
  for (unsigned int p = 0; p < exponents.size(); ++p)
  {
    if (std::abs(exponents[p]) < 0.01)
      throw InputError("Exponents = " + prm.get("Exponents") +
                       " is not allowed; each must be below -0.01 or above 0.01");
    if (!(shares[p] > 0))
      throw InputError("Weights = " + prm.get("Weights") + " is not allowed; each must be above 0");
  }
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.);
  for (double &share : shares)
    share /= sum;
}

template <int dim>
std::size_t Ogden<dim>::update(const Inputs<dim> &in, const Outputs<dim> &out) const
{
  for (std::size_t q = 0; q < in.n_points; ++q)
  {
    const dealii::Tensor<2, dim> &F = in.deformation_gradient[q];
    const double J = dealii::determinant(F);
    if (!is_admissible(J))
      return q;
    const PrincipalStretches<dim> stretches = principal_stretches(F, J);
    const double log_J = std::accumulate(stretches.log.begin(), stretches.log.end(), 0.);
    std::array<double, dim> tau;
    tau.fill(this->lambda * log_J);
    double energy = this->lambda / 2 * log_J * log_J;
    SpectralModulus<dim> modulus = {};
    for (unsigned int p = 0; p < exponents.size(); ++p)
    {
      const double alpha = exponents[p], factor = 2 * this->mu * shares[p];
      for (unsigned int a = 0; a < dim; ++a)
      {
        if (!(alpha * stretches.log[a] < largest_power))
          return q;
        const double less_one = std::expm1(alpha * stretches.log[a]);
        tau[a] += factor / alpha * less_one;
        modulus.normal[a][a] += factor * (less_one + 1);
        energy += factor / alpha * (less_one / alpha - stretches.log[a]);
        for (unsigned int b = 0; b < a; ++b)
          modulus.shear[b][a] += factor / alpha * power_slope(alpha, stretches.log[a], stretches.log[b]);
      }
    }
    if (out.stress)
      out.stress[q] = spectral_tensor<dim>(tau, stretches);
    if (out.tangent)
    {
      for (unsigned int a = 0; a < dim; ++a)
        for (unsigned int b = 0; b < dim; ++b)
        {
          modulus.normal[a][b] += this->lambda - (a == b ? 2 * tau[a] : 0.);
          modulus.shear[a][b] -= tau[stretches.log[a] <= stretches.log[b] ? b : a];
        }
      out.tangent[q] = modulus.rotated_to(stretches);
    }
    if (dim == 2 && out.out_of_plane_stress)
      out.out_of_plane_stress[q] = this->lambda * log_J;
    if (out.energy)
      out.energy[q] = energy;
    if (out.dissipation)
      out.dissipation[q] = 0;
  }
  return in.n_points;
}

template <int dim>
std::string Ogden<dim>::why_refused(const Inputs<dim> &point) const
{
  const dealii::Tensor<2, dim> &F = *point.deformation_gradient;
  const double J = dealii::determinant(F);
  if (!is_admissible(J))
    return "";
  const PrincipalStretches<dim> stretches = principal_stretches(F, J);
  for (const double alpha : exponents)
    for (const double log : stretches.log)
      if (!(alpha * log < largest_power))
      {
        std::ostringstream text;
        text << "was stretched by a factor of exp(" << log << "), whose power of " << alpha
             << " is beyond the numbers of its law 'Ogden'";
        return text.str();
      }
  return "";
}

template class Ogden<2>;
template class Ogden<3>;

namespace
{
[[maybe_unused]] const bool registered =
    register_law<Ogden>("ogden", "Rubber as a sum of powers of the principal stretches.");
}
} // namespace softgrain::constitutive
