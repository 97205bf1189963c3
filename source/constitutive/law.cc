// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/constitutive/law.h>

#include <algorithm>

namespace softgrain::constitutive
{
template <int dim>
void Law<dim>::declare_parameters(dealii::ParameterHandler &) const
{
}

template <int dim>
void Law<dim>::parse_parameters(dealii::ParameterHandler &)
{
}

template <int dim>
Kinematics Law<dim>::kinematics() const
{
  return Kinematics::finite_strain;
}

template <int dim>
unsigned int Law<dim>::n_history() const
{
  return 0;
}

template <int dim>
void Law<dim>::initial_history(double *history) const
{
  std::fill_n(history, n_history(), 0.);
}

template <int dim>
std::vector<std::string> Law<dim>::history_names() const
{
  return {};
}

template <int dim>
bool Law<dim>::symmetric_tangent() const
{
  return true;
}

template <int dim>
bool Law<dim>::limits_step() const
{
  return false;
}

template <int dim>
bool Law<dim>::is_active() const
{
  return false;
}

template <int dim>
double Law<dim>::poisson_ratio() const
{
  return 0;
}

template <int dim>
double Law<dim>::young_modulus() const
{
  const double nu = poisson_ratio();
  return wave_modulus() * (1 + nu) * (1 - 2 * nu) / (1 - nu);
}

template class Law<2>;
template class Law<3>;
} // namespace softgrain::constitutive
