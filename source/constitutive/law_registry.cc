// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/constitutive/law_registry.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::constitutive::Law<2>)
SOFTGRAIN_DEFINE_REGISTRY(softgrain::constitutive::Law<3>)

namespace softgrain::constitutive
{
namespace
{
template <int dim>
void declare_laws(dealii::ParameterHandler &prm)
{
  for (const std::string &name : Registry<Law<dim>>::instance().names())
  {
    const std::unique_ptr<Law<dim>> law = Registry<Law<dim>>::instance().create(name);
    prm.enter_subsection(law->title());
    law->declare_parameters(prm);
    prm.leave_subsection();
  }
}
} // namespace

std::vector<std::string> law_names()
{
  return Registry<Law<2>>::instance().names();
}

std::string law_title(const std::string &name)
{
  return Registry<Law<2>>::instance().create(name)->title();
}

void declare_all_laws(dealii::ParameterHandler &prm)
{
  check_registrations();
  // The parameters of a law are the same in 2D and 3D, so one dimension speaks for both.
  declare_laws<2>(prm);
}

template <int dim>
std::unique_ptr<Law<dim>> create_law(const std::string &name, dealii::ParameterHandler &prm)
{
  check_registrations();
  std::unique_ptr<Law<dim>> law;
  try
  {
    law = Registry<Law<dim>>::instance().create(name);
  }
  catch (const InputError &error)
  {
    throw InputError(std::string("constitutive law ") + error.what());
  }
  prm.enter_subsection(law->title());
  try
  {
    law->parse_parameters(prm);
  }
  catch (const InputError &error)
  {
    prm.leave_subsection();
    throw InputError("in subsection '" + law->title() + "': " + error.what());
  }
  prm.leave_subsection();
  return law;
}

template std::unique_ptr<Law<2>> create_law<2>(const std::string &, dealii::ParameterHandler &);
template std::unique_ptr<Law<3>> create_law<3>(const std::string &, dealii::ParameterHandler &);
} // namespace softgrain::constitutive
