// SPDX-License-Identifier: LGPL-2.1-or-later
// Disks on a square lattice.
#include <softgrain/packing/packing_method.h>

#include <deal.II/base/parameter_handler.h>

using namespace softgrain;

class SquareLattice final : public PackingMethod<2>
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry("Disks per side", "2", dealii::Patterns::Integer(1), "Units: none.");
    prm.declare_entry("Spacing", "1", dealii::Patterns::Double(1e-300), "Of the centres. Units: m.");
  }

  void parse_parameters(dealii::ParameterHandler &prm) override
  {
    side = prm.get_integer("Disks per side");
    spacing = prm.get_double("Spacing");
  }

  Packing<2> make() const override
  {
    Packing<2> packing;
    for (unsigned int i = 0; i < side; ++i)
      for (unsigned int j = 0; j < side; ++j)
        packing.balls.push_back({dealii::Point<2>((0.5 + i) * spacing, (0.5 + j) * spacing), 0.45 * spacing});
    return packing;
  }

private:
  unsigned int side = 2;
  double spacing = 1.;
};

[[maybe_unused]] const bool registered = Registry<PackingMethod<2>>::instance().add(
    "square_lattice", "disks on a square lattice", [] { return std::make_unique<SquareLattice>(); });
