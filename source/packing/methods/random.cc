// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/random.h>
#include <softgrain/packing/packing_method.h>
#include <softgrain/packing/parse_request.h>
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
    SizeDistribution::declare_parameters(prm, smallest, largest);
    prm.declare_entry(
        "Classes", "", Anything(),
        "Grains of several kinds, in place of a distribution of sizes: \"share: diameter [to diameter][, "
        "material][, "
        "shape]; ...\". Diameters are uniform from the one to the other; shape is disk, ellipse or polygon; "
        "numbers are "
        "rounded so that their sum is 'Number'. Two sizes: \"0.5: 2e-3; 0.5: 2.8e-3\". Units: m.");
    prm.declare_entry("Class table", "", Anything(),
                      "The same from a file, CSV with the columns share,smallest_m,largest_m and, where they "
                      "are needed, material "
                      "and shape: the steps of a sieve curve, for example.");
    prm.declare_entry(
        "Shares of", "number", Selection("number|area"),
        "What the shares of 'Classes' count: how many grains there are, or how much area they have.");
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
        "'Packing fraction' or 'Until jammed' does; up to about 0.84 is possible. Units: m.");
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
    parse_request(prm, request);
    parse_classes_of(prm);
    parse_mix(prm);
    request.protocol.jam = prm.get_bool("Until jammed");
    request.protocol.friction = prm.get_double("Friction");
    const std::string periodic = prm.get("Periodic");
    request.protocol.periodic = {
        {periodic.find('x') != std::string::npos, periodic.find('y') != std::string::npos}};
    if (request.protocol.jam && request.fraction > 0.)
      throw InputError(
          "'Packing/Packing fraction' = '" + prm.get("Packing fraction") +
          "' is not allowed with 'Packing/Until jammed' = 'true', which decides it: it must be 0");
    check_box(prm, request, largest_diameter(), "disk");
  }

  bool may_name_materials() const override
  {
    return !request.classes.empty() && !request.classes.front().material.empty();
  }

  std::vector<std::string> named_materials() const override
  {
    std::vector<std::string> names;
    for (const GrainClass2D &one : request.classes)
      if (!one.material.empty())
        names.push_back(one.material);
    return names;
  }

  bool asked_for(const dealii::ParameterHandler &prm) const override { return prm.get_integer("Number") > 0; }

  std::optional<ExpectedGrains> expected() const override
  {
    // The very radii that will be packed: with few disks the mean of the distribution says little.
    Uniform random(request.seed);
    std::vector<double> radii = draw_radii(request, random);
    ExpectedGrains disks;
    disks.number = request.number;
    for (const double r : radii)
      disks.mean_volume += dealii::numbers::PI * r * r / disks.number;
    const auto least = std::min_element(radii.begin(), radii.end());
    disks.smallest = 2. * *least * (request.only_disks() ? 1. : std::sqrt(request.mix.least_ratio));
    if (request.only_disks())
      disks.thinnest = "grain_" + std::to_string(least - radii.begin() + 1);
    const std::vector<unsigned int> numbers = request.numbers();
    for (std::size_t c = 0; c < numbers.size(); ++c)
      if (!request.classes[c].material.empty())
        disks.of_material[request.classes[c].material] += numbers[c];
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
  double largest_diameter() const
  {
    double largest = request.classes.empty() ? request.sizes.largest : 0.;
    for (const GrainClass2D &one : request.classes)
      largest = std::max(largest, one.largest);
    return largest;
  }

  void parse_classes_of(const dealii::ParameterHandler &prm)
  {
    const std::string text = prm.get("Classes"), table = prm.get("Class table");
    request.shares_of_area = prm.get("Shares of") == "area";
    if (!text.empty() && !table.empty())
      throw InputError("'Packing/Class table' = '" + table + "' is not allowed with 'Packing/Classes' = '" +
                       text + "': leave one of them out");
    const bool classes = !text.empty() || !table.empty();
    if (!classes && request.shares_of_area)
      throw InputError("'Packing/Shares of' = 'area' has no effect without 'Packing/Classes'");
    const std::string key = text.empty() ? "Class table" : "Classes";
    for (const auto &[name, unset] : {std::pair("Smallest diameter", smallest),
                                      {"Largest diameter", largest},
                                      {"Size distribution", "uniform area"}})
      if (classes && prm.get(name) != unset)
        throw InputError("'Packing/" + std::string(name) + "' = '" + prm.get(name) +
                         "' has no effect with 'Packing/" + key + "', which has the sizes");
    if (!classes)
      return;
    request.classes = text.empty() ? read_classes(table) : parse_classes(text);
    const double least =
        std::min_element(request.classes.begin(), request.classes.end(),
                         [](const auto &a, const auto &b) { return a.smallest < b.smallest; })
            ->smallest;
    if (largest_diameter() > 1000. * least)
      throw InputError(
          "'Packing/" + key +
          "' is not allowed: the smallest diameter must be at least a thousandth of the largest");
    request.numbers(); // whether there is a grain of each
  }

  static constexpr const char *smallest = "1.4e-3",
                              *largest = "2.4e-3"; ///< diameters unless the file has others [m]

  /// Whether grains may be of this kind.
  bool has(const GrainForm2D::Kind kind) const
  {
    const std::vector<GrainForm2D::Kind> &kinds = request.mix.kinds;
    const bool in_mix = std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
    return request.classes.empty()
               ? in_mix
               : std::any_of(request.classes.begin(), request.classes.end(),
                             [&](const GrainClass2D &one) { return one.kind ? *one.kind == kind : in_mix; });
  }

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
    const bool disks = request.only_disks(), polygons = has(GrainForm2D::Kind::polygon);
    if (disks)
      refuse("Aspect ratio", "1, 1", "has no effect with");
    if (!polygons)
      refuse("Corners", "5, 5", "has no effect with");
    if (!disks)
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
