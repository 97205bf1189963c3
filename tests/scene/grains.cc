// SPDX-License-Identifier: LGPL-2.1-or-later
// Random packings of ellipses and polygons: no overlaps by a test that knows nothing of the packing,
// everything inside of the box, areas and ratios as asked for, the same for the same seed; tables come back
// as they were written, and bad ones are refused.
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/ellipse.h>
#include <softgrain/geometry/shapes_2d.h>
#include <softgrain/packing/packing.h>
#include <softgrain/scene/packing_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <set>

using namespace softgrain;

namespace
{
/// The bodies of a section `Packing` with these lines.
Scene<2> bodies_of(const std::string &lines)
{
  dealii::ParameterHandler prm;
  PackingParameters::declare_parameters(prm);
  prm.parse_input_from_string("subsection Packing\n" + lines + "end\n");
  Scene<2> scene;
  scene.materials = {{"gel", "", 1.}, {"stone", "", 1.}};
  scene.packing = PackingParameters::parse_parameters<2>(prm, scene.materials);
  save_packing(scene.packing, add_packing(scene), true);
  return scene;
}

void look(const std::string &what, const std::string &lines, const double fraction)
{
  const std::string box =
      "  set Lower = 1, 2\n  set Upper = 21, 18\n  set Smallest diameter = 1.4\n  set Largest "
      "diameter = 2.4\n  set Material = gel\n  set Save to = grains.csv\n";
  const Scene<2> scene = bodies_of(box + lines), again = bodies_of(box + lines),
                 from_file = bodies_of("  set Material = gel\n  set File = grains.csv\n");
  double area = 0., outside = -1e9;
  unsigned int overlaps = 0, near = 0;
  bool same = true, as_written = true;
  std::set<std::size_t> corners;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
  {
    const Shape<2> &shape = *scene.bodies[i].shape;
    same = same && shape.numbers() == again.bodies[i].shape->numbers();
    as_written = as_written && shape.numbers() == from_file.bodies[i].shape->numbers();
    area += shape.area();
    if (shape.corners().size() < 100)
      corners.insert(shape.corners().size());
    const auto range = shape.bounding_box();
    outside = std::max(
        {outside, 1. - range.first[0], 2. - range.first[1], range.second[0] - 21., range.second[1] - 18.});
    for (std::size_t j = 0; j < i; ++j)
      overlaps += overlap(shape, *scene.bodies[j].shape, 1e-6);
    // A little larger, most grains of a dense packing would overlap something.
    const auto *const ellipse = dynamic_cast<const Ellipse2D *>(&shape);
    if (ellipse != nullptr)
    {
      const Ellipse2D larger(ellipse->center, 1.1 * ellipse->semi_axes, ellipse->angle);
      near += std::any_of(scene.bodies.begin(), scene.bodies.end(),
                          [&](const BodyDescription<2> &other)
                          { return other.shape.get() != &shape && overlap(larger, *other.shape, 1e-6); });
    }
  }
  std::cout << what << ": " << scene.bodies.size() << " grains, fraction off by "
            << (std::abs(area / 320. - fraction) < 1e-9 ? "nothing" : std::to_string(area / 320.)) << ", "
            << overlaps << " overlaps, " << (outside < 0. ? "inside" : "OUTSIDE") << ", "
            << (same ? "repeatable" : "NOT REPEATABLE") << ", "
            << (as_written ? "read as written" : "NOT AS WRITTEN") << ", corners";
  for (const std::size_t n : corners)
    std::cout << ' ' << n;
  std::cout << (near > 0 ? ", dense" : "") << '\n';
}

void refused(const std::string &table)
{
  std::ofstream("bad.csv") << table;
  try
  {
    bodies_of("  set File = bad.csv\n");
    std::cout << "NOT REFUSED\n";
  }
  catch (const InputError &error)
  {
    std::cout << error.what() << '\n';
  }
}
} // namespace

int main()
{
  look("ellipses",
       "  set Number = 60\n  set Shapes = ellipse\n  set Aspect ratio = 0.5, 0.8\n  set Packing fraction = "
       "0.75\n",
       0.75);
  look("regular pentagons", "  set Number = 60\n  set Shapes = polygon\n  set Packing fraction = 0.7\n", 0.7);
  look("all kinds",
       "  set Number = 60\n  set Shapes = disk, ellipse, polygon\n  set Corners = 3, 7\n  set Aspect ratio = "
       "0.6, 1\n  set "
       "Packing fraction = 0.68\n",
       0.68);
  look("loose ellipses",
       "  set Number = 20\n  set Shapes = ellipse\n  set Aspect ratio = 0.2, 0.4\n  set Packing fraction = "
       "0.1\n",
       0.1);

  // Written by hand: materials, and a square on its corner.
  std::ofstream("hand.csv")
      << "x_m,y_m,shape,a_m,b_m,corners,angle_deg,material\n"
         "0, 0, disk, 1, 1, 0, 0, gel\n4,0,ellipse,2,0.5,0,90,stone\n0,4,polygon,1,1,4,0,gel\n";
  const Scene<2> hand = bodies_of("  set File = hand.csv\n");
  for (const BodyDescription<2> &body : hand.bodies)
  {
    const auto box = body.shape->bounding_box();
    std::cout << body.name << ": material " << body.material << ", area " << body.shape->area() << ", from ("
              << box.first << ") to (" << box.second << ")\n";
  }
  const std::string head = "x_m,y_m,shape,a_m,b_m,corners,angle_deg\n";
  refused(head + "0,0,hexagon,1,1,6,0\n");
  refused(head + "0,0,ellipse,1,2,0,0\n");
  refused(head + "0,0,polygon,1,1,2,0\n");
  refused(head + "0,0,disk,1,1,0,0\n0,0,disk,1,0.5,0,0\n");
  refused(head + "0,0,ellipse,1,1,0\n");
  refused("x_m,y_m,shape,radius_m\n0,0,disk,1\n");
  try
  {
    bodies_of("  set Material = gel\n  set Number = 40\n  set Shapes = polygon\n  set Lower = 0, 0\n  set "
              "Upper = 12, 12\n  set "
              "Packing fraction = 0.9\n  set Smallest diameter = 2\n  set Largest diameter = 2\n");
    std::cout << "NOT REFUSED\n";
  }
  catch (const InputError &error)
  {
    std::cout << error.what() << '\n';
  }
}
