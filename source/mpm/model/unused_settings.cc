// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/model/unused_settings.h>
#include <softgrain/mpm/stepping/time_integrator.h>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
/// Parameters of one section that only some settings read.
struct Readers
{
  bool read;
  const char *section;
  std::vector<std::string> keys; ///< empty: all of the section
};
} // namespace

std::vector<std::string> unused_settings(const ParameterSection &all, const Settings &settings)
{
  const TimeScheme &scheme = settings.scheme;
  const bool rays = settings.meets_by_rays();
  const std::string by_scheme = "'Time/Scheme' = '" + scheme.name + "'",
                    by_geometry = "'Contact/Geometry' = '" + settings.contact_geometry + "'";
  const std::pair<std::string, std::vector<Readers>> list[] = {
      {by_scheme,
       {{scheme.integrator->reads_theta(), "Time", {"Theta"}},
        {scheme.ends_in_balance(), "Quasi-static", {"Regularisation", "Unbalanced force", "Held steps"}},
        {scheme.solves_equations(), "Newton", {}},
        {scheme.solves_equations(), "Linear solver", {}}}},
      {by_geometry,
       {{!rays, "Newton", {"Displacement tolerance", "Energy tolerance"}},
        {!rays || !scheme.solves_equations(),
         "Contact",
         {"Tolerance", "Maximum sweeps", "Relaxation", "Algorithm", "Keep failed problems in"}},
        {!rays, "Contact", {"Nodal gap", "Solver"}}}}};
  std::vector<std::string> lines;
  for (const auto &[with, readers] : list)
    for (const Readers &of : readers)
      if (!of.read)
        for (const ParameterEntry &entry : all.section(of.section)->entries)
          if (entry.value != entry.default_value &&
              (of.keys.empty() || std::find(of.keys.begin(), of.keys.end(), entry.name) != of.keys.end()))
            lines.push_back("'" + std::string(of.section) + "/" + entry.name + "' = '" + entry.value +
                            "' has no effect with " + with);
  return lines;
}
} // namespace softgrain::mpm
