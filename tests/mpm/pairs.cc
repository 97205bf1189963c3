// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction by pairs: of three blocks on one incline, tan(angle) = 0.4, two slide as Coulomb's law says for
// their own friction with the wall, by material and by name, and one sticks; a block on a block has that of
// the pair.
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
constexpr double g = 10.;
const double angle = std::atan(0.4);

std::string block(const std::string &name, const std::string &material, const std::string &center)
{
  return "subsection " + name + "\nset Shape = rectangle\nset Size = 8e-3, 4e-3\nset Material = " + material +
         "\nset Center = " + center + "\nend\n";
}

std::string scene(const std::string &bodies, const std::string &names)
{
  std::ostringstream text;
  text << R"(
subsection Mesh
  set Lower     = -2e-2, -3e-3
  set Upper     = 6e-2, 1.1e-2
  set Cell size = 1.3e-3
end
subsection Time
  set Theta     = 1
  set Time step = 5e-4
end
subsection Materials
  set Names = rough, slick
  subsection rough
    subsection Neo-Hookean
      set Young's modulus = 1e7
    end
  end
  subsection slick
    subsection Neo-Hookean
      set Young's modulus = 1e7
    end
  end
end
subsection Walls
  set Names = bottom
  subsection bottom
    set Friction = 0.7
  end
end
subsection Stop
  set End time = 0.1
end
)";
  text << "subsection Loads\nset Gravity = " << g * std::sin(angle) << ", " << -g * std::cos(angle)
       << "\nend\n";
  text << "subsection Bodies\nset Names = " << names << '\n' << bodies << "end\n";
  return text.str();
}

double speed(const mpm::MpmModel &model, const unsigned int body)
{
  return model.bodies()[body].nodes.momentum()[0] / model.bodies()[body].nodes.mass.sum();
}

/// Of all bodies down the plane, from 0.04 s to 0.08 s [m/s^2].
std::vector<double> accelerations(mpm::MpmModel &model)
{
  run_until(model, 0.04);
  std::vector<double> result;
  for (unsigned int b = 0; b < model.n_bodies(); ++b)
    result.push_back(-speed(model, b) / 0.04);
  run_until(model, 0.08);
  for (unsigned int b = 0; b < model.n_bodies(); ++b)
    result[b] += speed(model, b) / 0.04;
  return result;
}

double exact(const double mu)
{
  return std::max(0., g * (std::sin(angle) - mu * std::cos(angle)));
}

void on_a_wall()
{
  const auto model =
      scene_of_text(scene(block("a", "rough", "-1e-2, 2e-3") + block("b", "slick", "1e-2, 2e-3") +
                              block("c", "slick", "3e-2, 2e-3"),
                          "a, b, c"),
                    {"Contact/Friction of pairs=slick / bottom: 0.2; bottom / c: 0.3"});
  const std::vector<double> a = accelerations(*model);
  std::cout << "on a wall: as the wall says " << below(1e-3, a[0]) << ", by material " << a[1] / exact(0.2)
            << ", by name " << a[2] / exact(0.3) << " of the exact accelerations\n";
}

/// Acceleration of a disk on a block that sticks to the wall.
double on_a_block(const std::vector<std::string> &changes)
{
  std::vector<std::string> all = changes;
  all.push_back("Mesh/Cell size=0.9e-3");
  const auto model = scene_of_text(scene("subsection a\nset Shape = rectangle\nset Size = 30e-3, 4e-3\n"
                                         "set Material = rough\nset Center = 0, 2e-3\nend\n"
                                         "subsection b\nset Radius = 3e-3\nset Material = slick\n"
                                         "set Center = -8e-3, 7e-3\nend\n",
                                         "a, b"),
                                   all);
  return accelerations(*model)[1];
}
} // namespace

int main()
{
  on_a_wall();
  const std::string rough = "Contact/Friction=0.7", pairs = "Contact/Friction of pairs=";
  // A light contact is met by one ray, which follows it.
  const double alone = on_a_block({"Contact/Friction=0.05"});
  std::cout << "a disk on a block: slides with " << alone / exact(0.05)
            << " of the exact acceleration, the same by materials "
            << on_a_block({rough, pairs + "slick / rough: 0.05"}) / alone << " and by name "
            << on_a_block({rough, pairs + "slick / rough: 0.6; b / rough: 0.05"}) / alone
            << ", rolls where no entry fits "
            << on_a_block({rough, pairs + "slick / slick: 0"}) / (2. / 3. * g * std::sin(angle)) << '\n';
}
