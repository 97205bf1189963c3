// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/random.h>
#include <softgrain/packing/packing_method.h>
#include <softgrain/parameters/parameter_values.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
namespace
{
/// Grains thrown into a box that shrinks.
class RandomPacking final : public PackingMethod<2>
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    using namespace dealii::Patterns;
    prm.declare_entry(
        "Number", "0", Integer(0, 10000000),
        "Number of grains to pack at random, as bodies grain_1, grain_2, …; 0: none. Units: none.");
    SizeDistribution::declare_parameters(prm, "1.4e-3", "2.4e-3");
    prm.declare_entry(
        "Shapes", "disk", MultipleSelection("disk|ellipse|polygon"),
        "What the grains are: disks, ellipses, polygons, or several of these, each as often as the "
        "others, turned at random. Diameters are those of disks with the same area.");
    prm.declare_entry(
        "Aspect ratio", "1, 1", List(Double(0.1, 1.), 2, 2, ","),
        "Least and greatest ratio of the short to the long axis of ellipses, and of the ellipses on "
        "which polygons have their corners; drawn uniformly. Units: none.");
    prm.declare_entry("Corners", "5, 5", List(Integer(3, 100), 2, 2, ","),
                      "Least and greatest number of corners of polygons; with 'Aspect ratio' = 1, 1 they are "
                      "regular. Units: none.");
    prm.declare_entry("Lower", "0, 0", List(Double(), 2, 2, ","),
                      "Lower left corner of the box that the disks are packed in. Units: m.");
    prm.declare_entry(
        "Upper", "1, 1", List(Double(), 2, 2, ","),
        "Upper right corner of that box. Number, diameters and box decide how dense the packing is, unless "
        "'Packing fraction' or 'Until jammed' does; up to about 0.80 is possible. Units: m.");
    prm.declare_entry("Packing fraction", "0", Double(0., 0.9),
                      "Share of the box that the disks fill; all diameters are scaled by one factor to reach "
                      "it. 0: diameters are kept. Units: none.");
    prm.declare_entry("Until jammed", "false", Bool(),
                      "Whether the box shrinks until the disks resist, as under pressure. Then everything is "
                      "scaled to the box asked for: about 0.84 of it is filled without friction and walls.");
    prm.declare_entry("Friction", "0", Double(0.),
                      "Coefficient of friction between the disks, and with the sides of the box, while they "
                      "are packed. With more friction they jam at a lower density. Units: none.");
    prm.declare_entry(
        "Periodic", "", MultipleSelection("x|y"),
        "Directions in which the box has no sides: x, y or both. A disk that leaves on one side "
        "enters on the other, and disks reach over the edge. For packings without walls; a scene "
        "with a wall there refuses them.");
    prm.declare_entry("Seed", "1", Integer(0), "Seed of the random sizes and places. Units: none.");
  }

  void parse_parameters(dealii::ParameterHandler &prm) override
  {
    request.number = prm.get_integer("Number");
    if (request.number == 0)
      throw InputError(
          "'Packing/Number' = '0' is not allowed with 'Packing/Method' = 'random': it must be at least 1");
    if (!prm.get("File").empty())
      throw InputError("'Packing/File' = '" + prm.get("File") + "' is not allowed with 'Packing/Number' = '" +
                       prm.get("Number") + "': either make a packing or read one");
    request.sizes.parse_parameters(prm, "Packing");
    parse_mix(prm);
    request.lower = dealii::Point<2>(pair_of_numbers(prm.get("Lower")));
    request.upper = dealii::Point<2>(pair_of_numbers(prm.get("Upper")));
    request.fraction = prm.get_double("Packing fraction");
    request.seed = prm.get_integer("Seed");
    request.protocol.jam = prm.get_bool("Until jammed");
    request.protocol.friction = prm.get_double("Friction");
    const std::string periodic = prm.get("Periodic");
    request.protocol.periodic = {
        {periodic.find('x') != std::string::npos, periodic.find('y') != std::string::npos}};
    if (request.protocol.jam && request.fraction > 0.)
      throw InputError(
          "'Packing/Packing fraction' = '" + prm.get("Packing fraction") +
          "' is not allowed with 'Packing/Until jammed' = 'true', which decides it: it must be 0");
    for (unsigned int d = 0; d < 2; ++d)
      if (!(request.upper[d] - request.lower[d] > request.sizes.largest))
        throw InputError("'Packing/Upper' = '" + prm.get("Upper") +
                         "' is not allowed: the box from 'Lower' = '" + prm.get("Lower") +
                         "' on must be larger than a disk");
  }

  bool asked_for(const dealii::ParameterHandler &prm) const override { return prm.get_integer("Number") > 0; }

  std::optional<ExpectedGrains> expected() const override
  {
    // The very radii that will be packed: with few disks the mean of the distribution says little.
    Uniform random(request.seed);
    std::vector<double> radii = draw_radii(request, random);
    ExpectedGrains disks{static_cast<double>(request.number), 0., 0.};
    for (const double r : radii)
      disks.mean_volume += dealii::numbers::PI * r * r / disks.number;
    const double thin = 2. * *std::min_element(radii.begin(), radii.end());
    disks.smallest = request.mix.only_disks() ? thin : thin * std::sqrt(request.mix.least_ratio);
    if (request.protocol.jam)
    {
      // All are scaled to fill the box as jammed disks do.
      const double box = (request.upper[0] - request.lower[0]) * (request.upper[1] - request.lower[1]);
      const double larger = 0.83 * box / (disks.number * disks.mean_volume);
      disks.mean_volume *= larger;
      disks.smallest *= std::sqrt(larger);
    }
    return disks;
  }

  Packing<2> make() const override { return make_packing(request); }

private:
  void parse_mix(const dealii::ParameterHandler &prm)
  {
    const std::string shapes = prm.get("Shapes");
    GrainMix2D &mix = request.mix;
    mix.kinds.clear();
    for (const auto &[name, kind] : {std::pair("disk", GrainForm2D::Kind::disk),
                                     {"ellipse", GrainForm2D::Kind::ellipse},
                                     {"polygon", GrainForm2D::Kind::polygon}})
      if (shapes.find(name) != std::string::npos)
        mix.kinds.push_back(kind);
    if (mix.kinds.empty())
      throw InputError("'Packing/Shapes' = '' is not allowed: name at least one of disk, ellipse, polygon");
    const auto refuse = [&](const std::string &key, const std::string &without, const std::string &why)
    {
      if (prm.get(key) != without)
        throw InputError("'Packing/" + key + "' = '" + prm.get(key) + "' " + why + " 'Packing/Shapes' = '" +
                         shapes + "'");
    };
    if (mix.only_disks())
      refuse("Aspect ratio", "1, 1", "has no effect with");
    if (shapes.find("polygon") == std::string::npos)
      refuse("Corners", "5, 5", "has no effect with");
    if (!mix.only_disks())
    {
      refuse("Until jammed", "false", "is known for disks alone, not with");
      refuse("Periodic", "", "is known for disks alone, not with");
      if (prm.get_double("Friction") > 0.)
        refuse("Friction", "0", "is known for disks alone, not with");
    }
    const dealii::Tensor<1, 2> ratio = pair_of_numbers(prm.get("Aspect ratio")),
                               corners = pair_of_numbers(prm.get("Corners"));
    for (const auto &[key, range] : {std::pair("Aspect ratio", ratio), {"Corners", corners}})
      if (range[0] > range[1])
        throw InputError("'Packing/" + std::string(key) + "' = '" + prm.get(key) +
                         "' is not allowed: the second number must be at least the first");
    mix.least_ratio = ratio[0];
    mix.greatest_ratio = ratio[1];
    mix.least_corners = static_cast<unsigned int>(corners[0]);
    mix.most_corners = static_cast<unsigned int>(corners[1]);
  }

  PackingRequest2D request;
};

[[maybe_unused]] const bool registered =
    Registry<PackingMethod<2>>::instance().add("random",
                                               "'Number' grains thrown into a box that shrinks",
                                               [] { return std::make_unique<RandomPacking>(); });
} // namespace
} // namespace softgrain
