// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/parameters/parameter_tree.h>
#include <softgrain/scene/contact_law.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <vector>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::ContactLaw)

namespace softgrain
{
namespace
{
/// What a law declares: names and defaults.
std::vector<ParameterEntry> parameters_of(const std::string &law)
{
  dealii::ParameterHandler own;
  Registry<ContactLaw>::instance().create(law)->declare_parameters(own);
  return parameter_tree(own).entries;
}
} // namespace

double part_within(const double range, const double start, const double end)
{
  const double near = std::min(start, end), far = std::max(start, end);
  if (far <= range)
    return 1.;
  return near >= range ? 0. : (range - near) / (far - near);
}

double ContactLaw::mean_share(const double start, const double end, const double memory) const
{
  if (!std::isfinite(end))
    return 0.; // there is nothing to hold
  constexpr unsigned int places = 16;
  double sum = 0.;
  for (unsigned int k = 0; k < places; ++k)
    sum += share(std::max(0., start + (k + 0.5) / places * (end - start)), memory);
  return sum / places;
}

void declare_contact_laws(dealii::ParameterHandler &prm)
{
  const Registry<ContactLaw> &laws = Registry<ContactLaw>::instance();
  prm.declare_entry("Law", "coulomb", dealii::Patterns::Selection(laws.choice()), laws.choice_in_words());
  for (const std::string &law : laws.names())
    laws.create(law)->declare_parameters(prm);
}

std::shared_ptr<const ContactLaw> parse_contact_law(const dealii::ParameterHandler &prm)
{
  const Registry<ContactLaw> &laws = Registry<ContactLaw>::instance();
  const std::string chosen = prm.get("Law");
  std::shared_ptr<ContactLaw> law = laws.create(chosen);
  law->parse_parameters(prm);
  const std::vector<ParameterEntry> own = parameters_of(chosen);
  for (const std::string &other : laws.names())
    for (const ParameterEntry &entry : parameters_of(other))
      if (prm.get(entry.name) != entry.default_value &&
          std::none_of(own.begin(), own.end(),
                       [&entry](const ParameterEntry &mine) { return mine.name == entry.name; }))
        throw InputError("'Contact/" + entry.name + "' = '" + prm.get(entry.name) +
                         "' has no effect with 'Contact/Law' = '" + chosen + "': leave it out, or choose '" +
                         other + "'");
  return law;
}
} // namespace softgrain
