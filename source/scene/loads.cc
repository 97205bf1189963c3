// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/parameters/within_section.h>
#include <softgrain/scene/loads.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::Load<2>)
SOFTGRAIN_DEFINE_REGISTRY(softgrain::Load<3>)

namespace softgrain
{
template <int dim>
void Loads<dim>::declare_parameters(dealii::ParameterHandler &prm)
{
  const auto &known = Registry<Load<dim>>::instance();
  prm.enter_subsection("Loads");
  for (const std::string &name : known.names())
    known.create(name)->declare_parameters(prm);
  prm.leave_subsection();
}

template <int dim>
Loads<dim> Loads<dim>::parse_parameters(dealii::ParameterHandler &prm)
{
  const auto &known = Registry<Load<dim>>::instance();
  const WithinSection section(prm, "Loads");
  Loads loads;
  for (const std::string &name : known.names())
  {
    std::shared_ptr<Load<dim>> load = known.create(name);
    load->name = name;
    load->parse_parameters(prm);
    if (load->acts())
      loads.add(load);
  }
  return loads;
}

template <int dim>
std::vector<std::string> Loads<dim>::names() const
{
  std::vector<std::string> names;
  for (const auto &load : list)
    names.push_back(load->name);
  return names;
}

template <int dim>
bool Loads<dim>::see_velocity() const
{
  return std::any_of(list.begin(), list.end(), [](const auto &load) { return load->sees_velocity(); });
}

template <int dim>
bool Loads<dim>::look_at_points() const
{
  return std::any_of(list.begin(), list.end(), [](const auto &load) { return looks_at_points(*load); });
}

template <int dim>
dealii::Tensor<1, dim> Loads<dim>::uniform(const double time) const
{
  dealii::Tensor<1, dim> sum;
  LoadPlace<dim> anywhere;
  anywhere.time = time;
  for (const auto &load : list)
    if (load->is_uniform())
      sum += load->acceleration(anywhere);
  return sum;
}

template <int dim>
dealii::Tensor<1, dim> Loads<dim>::acceleration(const LoadPlace<dim> &place) const
{
  dealii::Tensor<1, dim> sum;
  for (const auto &load : list)
    sum += load->acceleration(place);
  return sum;
}

template class Loads<2>;
template class Loads<3>;
} // namespace softgrain
