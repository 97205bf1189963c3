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
template <int dim>
class PackingFromFile final : public PackingMethod<dim>
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry(
        "File", "", dealii::Patterns::Anything(),
        std::string("Table of grains to read: CSV with the columns ") +
            (dim == 2 ? "x_m, y_m, radius_m of disks, or x_m, y_m, shape, a_m, b_m, corners, angle_deg"
                      : "x_m, y_m, z_m, radius_m of balls") +
            " (doc/packings.md); where they are of several materials, material follows.");
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
    if constexpr (dim == 2)
      return expected_in_plane(read_packing<2>(file));
    return std::nullopt; // costs are foretold of the plane alone
  }

  Packing<dim> make() const override { return read_packing<dim>(file); }

private:
  static ExpectedGrains expected_in_plane(const Packing<2> &packing)
  {
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

  std::string file;
};

template <int dim>
bool register_method()
{
  return Registry<PackingMethod<dim>>::instance().add(
      "file", "grains that 'File' lists", [] { return std::make_unique<PackingFromFile<dim>>(); });
}
[[maybe_unused]] const bool registered = register_method<2>(), registered_in_space = register_method<3>();
} // namespace
} // namespace softgrain
