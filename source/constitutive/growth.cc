// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/constitutive/deformation.h>
#include <softgrain/constitutive/growth.h>
#include <softgrain/constitutive/law_registry.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace softgrain::constitutive
{
template <int dim>
Growth<dim>::Growth()
    : rate("0", {"t"}), directions{dealii::Point<dim>::unit_vector(0), dealii::Point<dim>::unit_vector(1)}
{
}

template <int dim>
void Growth<dim>::declare_parameters(dealii::ParameterHandler &prm) const
{
  ElasticLaw<dim>::declare_parameters(prm);
  prm.declare_entry("Rate", "0", dealii::Patterns::Anything(),
                    "Growth of area per area and time, a formula of the time t. Units: 1/s.");
  prm.declare_entry(
      "Along", "plane", dealii::Patterns::Anything(),
      "'plane': growth in all directions of the plane; a number: along this angle to the x axis "
      "at rest, in degrees.");
  prm.declare_entry("Largest growth", "0.1", dealii::Patterns::Double(0.),
                    "Growth of area per area in one step above which a shorter step is asked for; 0: any. "
                    "Units: none.");
}

template <int dim>
void Growth<dim>::parse_parameters(dealii::ParameterHandler &prm)
{
  ElasticLaw<dim>::parse_parameters(prm);
  rate = formula_of_time(prm.get("Rate"), "Rate");
  largest = prm.get_double("Largest growth");
  const std::string along = prm.get("Along");
  directions = {dealii::Point<dim>::unit_vector(0), dealii::Point<dim>::unit_vector(1)};
  if (along == "plane")
    return;
  if (!dealii::Patterns::Double().match(along))
    throw InputError("Along = '" + along + "' is not allowed; it must be 'plane' or an angle in degrees");
  const double angle = std::stod(along) * dealii::numbers::PI / 180;
  dealii::Tensor<1, dim> a;
  a[0] = std::cos(angle);
  a[1] = std::sin(angle);
  directions = {a};
}

template <int dim>
void Growth<dim>::initial_history(double *history) const
{
  history[0] = history[1] = 1;
  history[2] = 3;
  history[3] = directions.size();
}

template <int dim>
std::vector<std::string> Growth<dim>::history_names() const
{
  return {"growth", "volume_ratio", "squared_stretches", "squared_stretches_along_growth"};
}

template <int dim>
double Growth<dim>::growth_in_step(const double time, const double dt) const
{
  if (dt == 0.)
    return 0.;
  // Gauss's rule with three points.
  const std::lock_guard<std::mutex> lock(rate_mutex);
  const double arm = std::sqrt(0.15) * dt, middle = time - dt / 2;
  return dt / 18 * (5 * rate({middle - arm}) + 8 * rate({middle}) + 5 * rate({middle + arm}));
}

template <int dim>
double Growth<dim>::energy(const double grown, const double J, const double first, const double shared) const
{
  const double stretch = directions.size() == 1 ? grown * grown : grown, log_J = std::log(J / grown);
  return grown * (this->mu / 2 * (first + shared * (1 / stretch - 1) - 3 - 2 * log_J) +
                  this->lambda / 2 * log_J * log_J);
}

template <int dim>
double Growth<dim>::supply(const double growth, const double *old, const double *fresh) const
{
  if (growth == 0)
    return 0.;
  // Gauss's rule with four points: next to exact for any growth in a step that is not absurd.
  constexpr double place[] = {0.0694318442029737, 0.3300094782075719, 0.6699905217924281, 0.9305681557970263},
                   weight[] = {0.1739274225687269, 0.3260725774312731, 0.3260725774312731,
                               0.1739274225687269};
  const double exponent = directions.size() == 1 ? 2. : 1., more_volume = std::log(fresh[1] / old[1]),
               more_shared = std::log(fresh[3] / old[3]), rest = old[2] - old[3],
               more_rest = fresh[2] - fresh[3] - rest;
  double sum = 0.;
  for (unsigned int g = 0; g < 4; ++g)
  {
    const double s = place[g], grown = old[0] * std::exp(s * growth), J = old[1] * std::exp(s * more_volume),
                 shared = old[3] * std::exp(s * more_shared), first = rest + s * more_rest + shared;
    // d psi / d ln J_g at constant F.
    const double rate =
        energy(grown, J, first, shared) +
        grown * (this->mu * (1 - exponent / 2 * shared / (directions.size() == 1 ? grown * grown : grown)) -
                 this->lambda * std::log(J / grown));
    sum += weight[g] * rate;
  }
  return growth * sum;
}

template <int dim>
std::string Growth<dim>::why_refused(const Inputs<dim> &point) const
{
  const double growth = growth_in_step(point.time, point.dt), grown = point.history_old[0] * std::exp(growth);
  std::ostringstream text;
  if (!std::isfinite(growth))
    text << "cannot grow: 'Rate' of its law 'Growth' is no number between t = " << point.time - point.dt
         << " and " << point.time << " s";
  else if (!is_admissible(grown))
    text << "has grown beyond all numbers by its law 'Growth': from " << point.history_old[0]
         << " times its area by a factor of exp(" << growth << ")";
  return text.str();
}

template <int dim>
std::size_t Growth<dim>::update(const Inputs<dim> &in, const Outputs<dim> &out) const
{
  const double growth = growth_in_step(in.time, in.dt), factor = std::exp(growth);
  if (out.step_share && largest > 0 && std::abs(growth) > std::log1p(largest))
    *out.step_share = std::min(*out.step_share, std::log1p(largest) / std::abs(growth));
  for (std::size_t q = 0; q < in.n_points; ++q)
  {
    const dealii::Tensor<2, dim> &F = in.deformation_gradient[q];
    const double *old = in.history_old + q * n_history();
    const double J = dealii::determinant(F), grown = old[0] * factor;
    if (!is_admissible(J) || !is_admissible(grown) || !is_admissible(J / grown))
      return q;
    const double stretch = directions.size() == 1 ? grown * grown : grown, log_J = std::log(J / grown);
    dealii::SymmetricTensor<2, dim> b = left_cauchy_green(F);
    const double first = dealii::trace(b) + 3 - dim;
    double shared = 0;
    for (const dealii::Tensor<1, dim> &direction : directions)
    {
      const dealii::Tensor<1, dim> f = F * direction;
      shared += f * f;
      b += (1 / stretch - 1) * dealii::symmetrize(dealii::outer_product(f, f));
    }
    if (out.stress)
    {
      out.stress[q] = grown * this->mu * b;
      for (unsigned int i = 0; i < dim; ++i)
        out.stress[q][i][i] += grown * (this->lambda * log_J - this->mu);
    }
    if (out.tangent)
      out.tangent[q] =
          isotropic_modulus<dim>(grown * this->lambda, grown * (this->mu - this->lambda * log_J));
    if (dim == 2 && out.out_of_plane_stress)
      out.out_of_plane_stress[q] = grown * this->lambda * log_J;
    if (out.energy)
      out.energy[q] = energy(grown, J, first, shared);
    if (out.dissipation)
      out.dissipation[q] = 0;
    const double fresh[] = {grown, J, first, shared};
    if (out.supply)
      out.supply[q] = supply(growth, old, fresh);
    if (out.history_new)
      std::copy(std::begin(fresh), std::end(fresh), out.history_new + q * n_history());
  }
  return in.n_points;
}

template class Growth<2>;
template class Growth<3>;

namespace
{
[[maybe_unused]] const bool registered =
    register_law<Growth>("growth", "Neo-Hookean solid that grows in the plane or along one direction.");
}
} // namespace softgrain::constitutive
