// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/random.h>
#include <softgrain/packing/packing_method.h>
#include <softgrain/packing/parse_request.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

namespace softgrain
{
namespace
{
/// Balls thrown into a box of space that shrinks.
class RandomBalls final : public PackingMethod<3>
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    using namespace dealii::Patterns;
    prm.declare_entry(
        "Number", "0", Integer(0, 1000000),
        "Number of balls to pack at random, as bodies grain_1, grain_2, …; 0: none. Units: none.");
    SizeDistribution::declare_parameters(prm, "1.4e-3", "2.4e-3");
    prm.declare_entry(
        "Lower", "0, 0, 0", List(Double(), 3, 3, ","),
        "Corner of the box that the balls are packed in, with the smallest coordinates. Units: m.");
    prm.declare_entry(
        "Upper", "1, 1, 1", List(Double(), 3, 3, ","),
        "Corner of that box with the greatest coordinates. Number, diameters and box decide how "
        "dense the packing is, unless 'Packing fraction' does; up to about 0.64 is possible. "
        "Units: m.");
    prm.declare_entry("Packing fraction", "0", Double(0., 0.74),
                      "Share of the box that the balls fill; all diameters are scaled by one factor to reach "
                      "it. 0: diameters are kept. Units: none.");
    prm.declare_entry(
        "Periodic", "", MultipleSelection("x|y|z"),
        "Directions in which the box has no sides: x, y, z, or several, as x, z. A ball that leaves on one "
        "side enters on the other, and balls reach over the edge. For cells that repeat; a scene with a "
        "plane "
        "there refuses them.");
    prm.declare_entry("Seed", "1", Integer(0), "Seed of the random sizes and places. Units: none.");
  }

  void parse_parameters(dealii::ParameterHandler &prm) override
  {
    parse_request(prm, request);
    const std::string periodic = prm.get("Periodic");
    for (unsigned int d = 0; d < 3; ++d)
      request.periodic[d] = periodic.find("xyz"[d]) != std::string::npos;
    check_box(prm, request, request.fraction > 0. ? 0. : request.sizes.largest, "ball");
  }

  bool asked_for(const dealii::ParameterHandler &prm) const override { return prm.get_integer("Number") > 0; }

  Packing<3> make() const override { return make_packing(request); }

private:
  PackingRequest3D request;
};

[[maybe_unused]] const bool registered =
    Registry<PackingMethod<3>>::instance().add("random",
                                               "'Number' balls thrown into a box that shrinks",
                                               [] { return std::make_unique<RandomBalls>(); });
} // namespace
} // namespace softgrain
