// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/output/hdf5_writer.h>
#include <softgrain/output/units.h>

#include <array>
#include <utility>

namespace softgrain
{
namespace
{
/// Longest first: `_m_per_s` ends with `_s`.
constexpr std::array<std::pair<const char *, const char *>, 25> units = {{{"_kg_m_per_s", "kg m/s"},
                                                                          {"_kg_per_m3", "kg/m^3"},
                                                                          {"_rad_per_s", "rad/s"},
                                                                          {"_J_per_m3", "J/m^3"},
                                                                          {"_N_per_m2", "N/m^2"},
                                                                          {"_m_per_s2", "m/s^2"},
                                                                          {"_kg_per_m", "kg/m"},
                                                                          {"_per_rad", "1/rad"},
                                                                          {"_per_Pa", "1/Pa"},
                                                                          {"_N_per_m", "N/m"},
                                                                          {"_J_per_m", "J/m"},
                                                                          {"_m_per_s", "m/s"},
                                                                          {"_per_s", "1/s"},
                                                                          {"_per_m", "1/m"},
                                                                          {"_bytes", "byte"},
                                                                          {"_N_m", "N m"},
                                                                          {"_rad", "rad"},
                                                                          {"_Pa", "Pa"},
                                                                          {"_kg", "kg"},
                                                                          {"_m3", "m^3"},
                                                                          {"_m2", "m^2"},
                                                                          {"_N", "N"},
                                                                          {"_J", "J"},
                                                                          {"_m", "m"},
                                                                          {"_s", "s"}}};
} // namespace

std::string unit_of(const std::string &name)
{
  for (const auto &[ending, unit] : units)
  {
    const std::string end = ending;
    if (name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0)
      return unit;
  }
  return "1";
}

void write_units(Hdf5Writer &file)
{
  for (const std::string &name : file.array_names())
    if (file.array_type(name) == 'd')
      file.write_attribute(name, "units", unit_of(name));
}
} // namespace softgrain
