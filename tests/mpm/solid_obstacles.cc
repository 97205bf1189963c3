// SPDX-License-Identifier: LGPL-2.1-or-later
// Sheets as obstacles in space. A plate that comes down presses as the wall does, whether it is a disk or the
// triangles of a file, also when all is tilted. A ball between a wall and a cone is in balance, and its
// mirror image is. A ball that lies on a plate that turns gets friction times what the plate bears, and work
// is torque times angle.
#include "moving_balls.h"
#include "two_balls.h"

#include <softgrain/base/exceptions.h>

namespace
{
std::string obstacle(const std::string &lines)
{
  return "subsection Obstacles\n  set Names = plate\n  subsection plate\n" + lines + "  end\nend\n";
}

/// A ball on a wall, under a plate or a wall that comes down by .4 a second. @param top of a wall
std::string pressed(const std::string &top, const std::string &plate)
{
  return R"(
set Dimension = 3
subsection Mesh
  set Lower = -3.2, -3.2, -1
  set Upper = 3.2, 3.2, 6.2
  set Cell size = 0.8
end
subsection Time
  set Scheme = quasi_static
  set Wall way = 0.1
end
)" + softgrain::gel("0.4", "1", "1000") +
         R"(subsection Bodies
  set Names = a
  subsection a
    set Shape  = sphere
    set Center = 0.07, -0.11, 2.5
    set Radius = 2.5
  end
end
subsection Walls
  set Names = bottom)" +
         (top.empty() ? "" : ", top") + "\n  subsection bottom\n    set Point = 0, 0, 0\n  end\n" +
         (top.empty() ? "" : "  subsection top\n    set Point = 0, 0, 5\n" + top + "  end\n") + "end\n" +
         plate + "subsection Stop\n  set End time = 2\nend\n";
}

struct Found
{
  double bottom = 0., work = 0., energy = 0.;
  ObstacleState<3> plate;
  unsigned int iterations = 0;
};

Found found(const std::string &text, const std::vector<std::string> &changes = {})
{
  std::ofstream("scene.prm") << text;
  const auto model = model_of("scene.prm", changes);
  Found result;
  while (model->time() < 2. * (1. - 1e-12))
  {
    StepReport report = model->advance(2. - model->time());
    model->settle(report);
    result.iterations += report.newton_iterations;
  }
  result.bottom = model->walls()[0].normal_force;
  result.work = model->energies().external_work;
  result.energy = (model->energies().elastic + model->energies().dissipated) / result.work - 1.;
  if (!model->obstacles().empty())
    result.plate = model->obstacles()[0];
  return result;
}

void write_square()
{
  std::ofstream file("square.stl");
  file << "solid\n";
  for (const std::string &corners :
       {"-9 -9 0\nvertex 9 -9 0\nvertex 8 9 0", "-9 -9 0\nvertex 8 9 0\nvertex -9 9 0"})
    file << "facet\nouter loop\nvertex " << corners << "\nendloop\nendfacet\n";
  file << "endsolid\n";
}

const std::string down = "    set Thickness = 1\n    set Displacement = 0; 0; -0.4*t\n";

void plates()
{
  write_square();
  const Found wall = found(pressed("    set Velocity = 0.4\n", ""));
  std::cout << "energy under a wall " << below(0.01, wall.energy) << '\n';
  const auto compare = [&](const std::string &name, const Found &other)
  {
    std::cout << name << ": force below off by " << below(1e-3, other.bottom / wall.bottom - 1.)
              << ", against that on the plate " << below(1e-4, other.plate.force[2] / other.bottom - 1.)
              << ", aside " << below(1e-6, other.plate.force[0] / other.bottom) << ", work off by "
              << below(2e-3, other.work / wall.work - 1.) << ", energy " << below(0.01, other.energy) << '\n';
  };
  compare("disk", found(pressed("", obstacle("    set Points = 0, 5.5; 9, 5.5\n" + down))));
  compare("triangles",
          found(pressed("", obstacle("    set Shape = stl\n    set File = square.stl\n    set Thickness = 1\n"
                                     "    set Displacement = 0; 0; 5.5 - 0.4*t\n"))));
}

/// @param side 1; -1: the mirror image at x = 0
Found in_a_cone(const double side, const std::string &friction)
{
  const std::string x = std::to_string(-side * 0.14);
  return found(pressed("", obstacle("    set Points = 1, 6.3; 5, 2.3\n    set Center = " + x +
                                    ", -0.2, 0\n    set Thickness = 1\n    set Displacement = 0; 0; -0.5*t\n"
                                    "    set Friction = " +
                                    friction + "\n")),
               {"Bodies/a/Center=" + std::to_string(side * 0.07) + ", -0.11, 2.5"});
}

void on_a_plate_that_turns()
{
  const double friction = 0.3;
  MovingBalls ball(text_of(1, false) + obstacle("    set Points = 0, 0; 30, 0\n    set Thickness = 1\n"
                                                "    set Friction = 0.3\n    set Angle = 1*t\n"),
                   {"Bodies/a/Center=4, 0, 2.91", "Loads/Gravity=0, 0, -1e-4"});
  const double before = ball.total_energy();
  double torque_by_angle = 0., turned = 0.;
  ball.run(60.,
           [&](const StepReport &)
           {
             const ObstacleState<3> plate = ball.model->obstacles()[0];
             torque_by_angle -= plate.torque * (plate.angle - turned);
             turned = plate.angle;
           });
  const dealii::Tensor<1, 3> given = ball.momentum();
  const double borne = given[2] + ball.state().bodies[0].nodes.mass.sum() * 1e-4 * ball.model->time();
  std::cout << "on a plate that turns: friction over what it bears " << given[1] / borne / friction
            << ", work over torque times angle " << ball.model->energies().external_work / torque_by_angle
            << ", energy " << below(1e-2, (ball.total_energy() - before) / ball.model->energies().kinetic)
            << '\n';
}

void refused(const std::string &plate)
{
  try
  {
    std::ofstream("scene.prm") << pressed("", obstacle(plate));
    model_of("scene.prm", {});
    std::cout << "not refused\n";
  }
  catch (const softgrain::InputError &error)
  {
    std::cout << error.what() << '\n';
  }
}
} // namespace

int main()
{
  plates();
  for (const std::string friction : {"0", "0.3"})
  {
    const Found cone = in_a_cone(1., friction), image = in_a_cone(-1., friction);
    std::cout << "cone with friction " << friction << ": over bottom "
              << below(1e-4, cone.plate.force[2] / cone.bottom - 1.) << ", aside "
              << below(0.2, cone.plate.force[0] / cone.bottom) << ", energy " << below(0.03, cone.energy)
              << ", mirror image " << below(friction == "0" ? 1e-6 : 2e-3, image.bottom / cone.bottom - 1.)
              << ", " << below(1e-4, (image.plate.force[0] + cone.plate.force[0]) / cone.bottom) << '\n';
  }
  on_a_plate_that_turns();
  refused("    set Points = 0, 5.5; 9, 5.5\n");
  refused("    set Points = 0, 5.5; 9, 5.5\n    set Thickness = 0.7\n");
  refused("    set Points = 0, 5.2; 9, 5.2\n    set Thickness = 1\n");
  refused("    set Points = 0, 5.5; -9, 5.5\n    set Thickness = 1\n");
  refused("    set Shape = stl\n    set File = nothing.stl\n    set Thickness = 1\n");
}
