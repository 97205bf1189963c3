// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/packing/packing_method.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

namespace softgrain
{
namespace
{
/// Disks from a table.
class PackingFromFile final : public PackingMethod
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry(
        "File", "", dealii::Patterns::Anything(),
        "Table of disks to read: CSV with the columns x_m, y_m, radius_m and, where the disks are of "
        "several materials, material.");
  }

  void parse_parameters(dealii::ParameterHandler &prm) override
  {
    file = prm.get("File");
    if (file.empty())
      throw InputError("'Packing/File' is missing: with 'Packing/Method' = 'file' it must name a file");
    if (!prm.get("Save to").empty())
      throw InputError("'Packing/Save to' = '" + prm.get("Save to") +
                       "' has no effect on disks that are read from 'Packing/File'");
  }

  bool asked_for(const dealii::ParameterHandler &prm) const override { return !prm.get("File").empty(); }
  bool may_name_materials() const override { return true; }

  std::optional<ExpectedDisks> expected() const override
  {
    const Packing packing = read_packing(file);
    ExpectedDisks disks{static_cast<double>(packing.disks.size()),
                        packing.solid_area() / packing.disks.size(), 0.};
    for (const Packing::Disk &disk : packing.disks)
      if (disks.smallest == 0. || 2. * disk.radius < disks.smallest)
        disks.smallest = 2. * disk.radius;
    return disks;
  }

  Packing make() const override { return read_packing(file); }

private:
  std::string file;
};

[[maybe_unused]] const bool registered = Registry<PackingMethod>::instance().add(
    "file", "disks that 'File' lists", [] { return std::make_unique<PackingFromFile>(); });
} // namespace
} // namespace softgrain
