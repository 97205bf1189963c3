// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/constitutive/elastic_law.h>

#include <deal.II/base/parameter_handler.h>

namespace softgrain::constitutive
{
namespace
{
// The material of the thesis's particles.
constexpr double default_young = 10e6;
constexpr double default_poisson = 0.45;
} // namespace

template <int dim>
ElasticLaw<dim>::ElasticLaw()
{
  set_constants(default_young, default_poisson);
}

template <int dim>
void ElasticLaw<dim>::set_constants(const double young_modulus, const double poisson_ratio)
{
  young = young_modulus;
  poisson = poisson_ratio;
  lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson));
  mu = young / (2 * (1 + poisson));
}

template <int dim>
void ElasticLaw<dim>::declare_parameters(dealii::ParameterHandler &prm) const
{
  prm.declare_entry("Young's modulus", "10e6", dealii::Patterns::Double(0.),
                    "Young's modulus at small strain, above 0. Units: Pa.");
  prm.declare_entry(
      "Poisson's ratio", "0.45", dealii::Patterns::Double(-1., 0.5),
      "Poisson's ratio at small strain, above -1 and below 0.5; 0.4999 is nearly incompressible. "
      "Units: none.");
}

template <int dim>
void ElasticLaw<dim>::parse_parameters(dealii::ParameterHandler &prm)
{
  // The patterns include their ends, which no elastic solid reaches.
  const double young_modulus = prm.get_double("Young's modulus");
  if (!(young_modulus > 0))
    throw InputError("Young's modulus = " + prm.get("Young's modulus") +
                     " Pa is not allowed; it must be above 0");
  const double poisson_ratio = prm.get_double("Poisson's ratio");
  if (!(poisson_ratio < 0.5))
    throw InputError(
        "Poisson's ratio = " + prm.get("Poisson's ratio") +
        " is not allowed: an incompressible solid has an infinite bulk modulus; it must be below 0.5, "
        "for example 0.4999");
  if (!(poisson_ratio > -1))
    throw InputError("Poisson's ratio = " + prm.get("Poisson's ratio") +
                     " is not allowed; it must be above -1");
  set_constants(young_modulus, poisson_ratio);
}

template <int dim>
double ElasticLaw<dim>::wave_modulus() const
{
  return lambda + 2 * mu;
}

template <int dim>
double ElasticLaw<dim>::poisson_ratio() const
{
  return poisson;
}

template <int dim>
double ElasticLaw<dim>::young_modulus() const
{
  return young;
}

template class ElasticLaw<2>;
template class ElasticLaw<3>;
} // namespace softgrain::constitutive
