// SPDX-License-Identifier: LGPL-2.1-or-later
// An ellipsoid and a box with round edges, both turned, one obliquely above the other in a box that becomes
// lower. Every state is in balance, and what walls do is stored. The mirror image, the same with the names
// exchanged, with the ellipsoid told by other axes, and with two threads, is the same. A ball that is told as
// an ellipsoid takes the forces of a ball, where the grid shows all of its dents and has as many nodes. With
// friction rounding decides which rays slide while the bodies turn under light forces, so the mirror image
// ends beside.
#include "two_balls.h"

#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>

using namespace softgrain;
using namespace softgrain::mpm;

namespace
{
using Changes = std::vector<std::string>;

Changes ellipsoid(const std::string &name,
                  const std::string &center,
                  const std::string &axes,
                  const std::string &rotation)
{
  const std::string body = "Bodies/" + name + "/";
  return {body + "Shape=ellipsoid", body + "Radius=0", body + "Center=" + center, body + "Semi-axes=" + axes,
          body + "Rotation=" + rotation};
}

Changes box(const std::string &name, const std::string &center, const std::string &rotation)
{
  const std::string body = "Bodies/" + name + "/";
  return {body + "Shape=superellipsoid",    body + "Radius=0",       body + "Center=" + center,
          body + "Semi-axes=2.1, 2.0, 2.2", body + "Exponents=3, 4", body + "Rotation=" + rotation};
}

Changes both(Changes a, const Changes &b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const Changes wide = {"Walls/left/Point=-3.6, 0, 0", "Walls/right/Point=3.6, 0, 0",
                      "Walls/top/Point=0, 0, 8.85", "Stop/End time=1.8"};

Outcome pressed_solids(const Changes &changes)
{
  std::ofstream("scene.prm") << two;
  const auto model = model_of("scene.prm", both(wide, changes));
  return run(*model, 1.8, 0.01);
}

const std::string low = "-1.15, -0.2, 2.4", high = "1.1, 0.15, 6.46", low_image = "1.15, -0.2, 2.4",
                  high_image = "-1.1, 0.15, 6.46", axes = "2.4, 2.1, 2.2";

void look(const std::string &title, const double mirrored, const double swapped, const Changes &more)
{
  const auto with = [&](const Changes &solids) { return pressed_solids(both(solids, more)); };
  const Changes lower = ellipsoid("a", low, axes, "10, 20, 90"), upper = box("b", high, "-15, 8, 30");
  const Outcome pressed = with(both(lower, upper));
  std::cout << title << ": balance within 1e-3 " << (pressed.left_over < 1e-3)
            << ", less than 25 iterations a step " << (pressed.iterations < 25 * pressed.steps)
            << ", energy off by " << below(0.06, pressed.energy) << '\n';
  const Outcome image =
      with(both(ellipsoid("a", low_image, axes, "10, -20, -90"), box("b", high_image, "-15, -8, -30")));
  std::cout << "  mirror image off by " << below(mirrored, off(pressed, image, {0, 1, 3, 2, 4, 5})) << '\n';
  const Outcome exchanged = with(both(ellipsoid("b", low, axes, "10, 20, 90"), box("a", high, "-15, 8, 30")));
  std::cout << "  exchanged off by " << below(swapped, off(pressed, exchanged, {0, 1, 2, 3, 4, 5})) << '\n';
  set_n_threads(2);
  std::cout << "  two threads same " << (with(both(lower, upper)).forces == pressed.forces) << '\n';
  set_n_threads(1);
}
} // namespace

int main()
{
  look("without friction", 1e-7, 1e-7, {});
  look("with friction", 3e-2, 1e-5, {"Contact/Friction=0.4", "Contact/Friction at walls=same"});
  // A turn by a third of the way around (1, 1, 1) takes every axis to the next one.
  const Changes upper = both(box("b", high, "0, 0, 30"), {"Newton/Residual tolerance=1e-9"});
  const std::string third = "69.282032302755, 69.282032302755, 69.282032302755";
  const Outcome turned = pressed_solids(both(ellipsoid("a", low, axes, third), upper)),
                other = pressed_solids(both(ellipsoid("a", low, "2.2, 2.4, 2.1", "0, 0, 0"), upper));
  std::cout << "told by other axes, off by " << below(1e-7, off(turned, other, {0, 1, 2, 3, 4, 5})) << '\n';
  const auto balls = [&](const Changes &shapes)
  {
    return pressed_solids(
        both({"Contact/Sub-grid compliance=false", "Material points/Fill limit=0.6", "Contact/Friction=0.4"},
             shapes));
  };
  const Outcome round = balls({"Bodies/a/Center=" + low, "Bodies/b/Center=" + high, "Bodies/a/Radius=2.1",
                               "Bodies/b/Radius=2.2"}),
                same = balls(both(ellipsoid("a", low, "2.1, 2.1, 2.1", "0, 0, 0"),
                                  ellipsoid("b", high, "2.2, 2.2, 2.2", "0, 0, 0")));
  std::cout << "balls as ellipsoids off by " << below(1e-7, off(round, same, {0, 1, 2, 3, 4, 5})) << '\n';
  for (const Changes &wrong : {Changes{"Bodies/a/Shape=ellipsoid", "Bodies/a/Radius=0"},
                               Changes{"Bodies/a/Shape=superellipsoid", "Bodies/a/Radius=0",
                                       "Bodies/a/Semi-axes=2, 2, 2", "Bodies/a/Exponents=2, 30"},
                               ellipsoid("a", "0.2, 0, 2.6", "2.3, 2.3, 2.3", "0, 0, 0")})
    try
    {
      two_balls(wrong);
    }
    catch (const InputError &error)
    {
      std::cout << error.what() << '\n';
    }
}
