// SPDX-License-Identifier: LGPL-2.1-or-later
// A tetrahedron with round edges obliquely on a block in a box that becomes lower. Without friction it turns
// until walls hold it, which takes a tenth of their work; every state is in balance. The mirror image, the
// same with the names exchanged, with corners in another order and with two threads, is the same. A rod that
// lies on a plate takes the force of one whose corners are told with the middle, and a ball told by one
// corner the force of a ball. A pin is the same as a rod and as a cylinder.
#include "two_balls.h"

#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>

using namespace softgrain;
using namespace softgrain::mpm;

namespace
{
using Changes = std::vector<std::string>;

Changes polyhedron(const std::string &name,
                   const std::string &center,
                   const std::string &vertices,
                   const std::string &radius,
                   const std::string &rotation)
{
  const std::string body = "Bodies/" + name + "/";
  return {body + "Shape=polyhedron",      body + "Radius=0",
          body + "Center=" + center,      body + "Vertices=" + vertices,
          body + "Edge radius=" + radius, body + "Rotation=" + rotation};
}

Changes both(Changes a, const Changes &b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const std::string block = "1.2, 1, .8; -1.2, 1, .8; 1.2, -1, .8; -1.2, -1, .8; "
                          "1.2, 1, -.8; -1.2, 1, -.8; 1.2, -1, -.8; -1.2, -1, -.8",
                  block_image = "-1.2, 1, .8; 1.2, 1, .8; -1.2, -1, .8; 1.2, -1, .8; "
                                "-1.2, 1, -.8; 1.2, 1, -.8; -1.2, -1, -.8; 1.2, -1, -.8",
                  tetrahedron = "1.2, 1.2, 1.2; 1.2, -1.2, -1.2; -1.2, 1.2, -1.2; -1.2, -1.2, 1.2",
                  other_order =
                      "-1.2, 1.2, -1.2; 1.2, 1.2, 1.2; 0.1, 0.2, 0; -1.2, -1.2, 1.2; 1.2, -1.2, -1.2",
                  tetrahedron_image = "-1.2, 1.2, 1.2; -1.2, -1.2, -1.2; 1.2, 1.2, -1.2; 1.2, -1.2, 1.2";

Outcome pressed(const Changes &solids, const Changes &more = {})
{
  std::ofstream("scene.prm") << two;
  const Changes wide = {
      "Walls/left/Point=-3.1, 0, 0", "Walls/right/Point=3.1, 0, 0", "Walls/front/Point=0, -3.1, 0",
      "Walls/back/Point=0, 3.1, 0",  "Walls/top/Point=0, 0, 9.5",   "Stop/End time=2.7",
      "Mesh/Cell size=1.2"};
  const auto model = model_of("scene.prm", both(both(wide, solids), more));
  return run(*model, 2.7, 0.012);
}

Changes pair(const std::string &low, const std::string &high, const std::string &corners)
{
  return both(polyhedron(low, "-0.3, 0.2, 2.1", block, "1", "6, 9, 40"),
              polyhedron(high, "0.4, -0.1, 6.6", corners, "1.1", "-15, 8, 30"));
}

void compare(const std::string &what, const double limit, const Outcome &a, const Outcome &b)
{
  std::cout << "  " << what << " off by " << below(limit, off(a, b, {0, 1, 2, 3, 4, 5})) << '\n';
}
} // namespace

int main()
{
  const Outcome found = pressed(pair("a", "b", tetrahedron));
  std::cout << "balance within 1e-3 " << (found.left_over < 1e-3) << ", less than 25 iterations a step "
            << (found.iterations < 25 * found.steps) << ", energy off by " << below(0.15, found.energy)
            << '\n';
  const Outcome image =
      pressed(both(polyhedron("a", "0.3, 0.2, 2.1", block_image, "1", "6, -9, -40"),
                   polyhedron("b", "-0.4, -0.1, 6.6", tetrahedron_image, "1.1", "-15, -8, -30")));
  std::cout << "  mirror image off by " << below(1e-6, off(found, image, {0, 1, 3, 2, 4, 5})) << '\n';
  compare("exchanged", 1e-6, found, pressed(pair("b", "a", tetrahedron)));
  compare("corners in another order", 1e-6, found, pressed(pair("a", "b", other_order)));
  set_n_threads(2);
  std::cout << "  two threads same " << (pressed(pair("a", "b", tetrahedron)).forces == found.forces) << '\n';
  set_n_threads(1);

  const Changes plate =
      polyhedron("a", "0, 0, 2", "1, 1, 0; -1, 1, 0; -1, -1, 0; 1, -1, 0", "1.9", "0, 0, 10");
  const auto with_rod = [&](const std::string &vertices)
  { return pressed(both(plate, polyhedron("b", "0.1, 0.2, 6.2", vertices, "1.8", "5, 3, 25"))); };
  const Outcome rod = with_rod("-1.2, 0, 0; 1.2, 0, 0");
  std::cout << "rod on plate: pressed by " << rod.forces[1] << ", balance within 1e-3 "
            << (rod.left_over < 1e-3) << ", energy off by " << below(0.06, rod.energy) << '\n';
  compare("told with its middle", 1e-6, rod, with_rod("0, 0, 0; 1.2, 0, 0; -1.2, 0, 0"));

  const std::string across = "0.1, 0.2, 6.2", turned = "0, 90, 10";
  compare(
      "a pin as a cylinder", 1e-6,
      pressed(both(plate, polyhedron("b", across, "0, 0, 1.2; 0, 0, -1.2", "1.8", turned))),
      pressed(both(plate, {"Bodies/b/Shape=cylinder", "Bodies/b/Center=" + across, "Bodies/b/Radius=1.8",
                           "Bodies/b/Height=6", "Bodies/b/Edge radius=1.8", "Bodies/b/Rotation=" + turned})));

  const Changes rough = {"Contact/Friction=0.4"};
  const Outcome ball = pressed(both(plate, {"Bodies/b/Center=0.1, 0.2, 6.2", "Bodies/b/Radius=2.2"}), rough);
  compare("a ball as one corner", 1e-7, ball,
          pressed(both(plate, polyhedron("b", "0.1, 0.2, 6.2", "0, 0, 0", "2.2", "0, 0, 0")), rough));
  for (const Changes &wrong :
       {Changes{"Bodies/a/Shape=polyhedron", "Bodies/a/Radius=0"},
        Changes{"Bodies/a/Shape=polyhedron", "Bodies/a/Radius=0", "Bodies/a/Vertices=0, 0, 0"},
        polyhedron("a", "0, 0, 3", "-2.5, 0, 0; 2.5, 0, 0", "0.2", "0, 0, 0"),
        Changes{"Bodies/a/Shape=box", "Bodies/a/Radius=0", "Bodies/a/Size=3, 2, 1",
                "Bodies/a/Edge radius=0.6"},
        Changes{"Bodies/a/Shape=cylinder", "Bodies/a/Height=3", "Bodies/a/Edge radius=3"}})
    try
    {
      two_balls(wrong);
    }
    catch (const InputError &error)
    {
      std::cout << error.what() << '\n';
    }
}
