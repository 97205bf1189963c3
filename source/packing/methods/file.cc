// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/packing/packing_method.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

namespace softgrain
{
namespace
{
/// Grains from a table.
class PackingFromFile final : public PackingMethod<2>
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry(
        "File", "", dealii::Patterns::Anything(),
        "Table of grains to read: CSV with the columns x_m, y_m, radius_m of disks, or x_m, y_m, shape, a_m, "
        "b_m, corners, angle_deg (doc/packings.md); where they are of several materials, material follows.");
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

  std::optional<ExpectedGrains> expected() const override
  {
    const Packing<2> packing = read_packing(file);
    ExpectedGrains disks;
    disks.number = packing.balls.size();
    disks.mean_volume = solid_area(packing) / packing.balls.size();
    for (const std::string &material : packing.materials)
      ++disks.of_material[material];
    for (std::size_t i = 0; i < packing.balls.size(); ++i)
    {
      const double width = form_of(packing, i).width(packing.balls[i].radius);
      if (disks.smallest != 0. && width >= disks.smallest)
        continue;
      disks.smallest = width;
      disks.thinnest = "grain_" + std::to_string(i + 1);
    }
    return disks;
  }

  Packing<2> make() const override { return read_packing(file); }

private:
  std::string file;
};

[[maybe_unused]] const bool registered = Registry<PackingMethod<2>>::instance().add(
    "file", "grains that 'File' lists", [] { return std::make_unique<PackingFromFile>(); });
} // namespace
} // namespace softgrain
