// SPDX-License-Identifier: LGPL-2.1-or-later
// Walls that slide in space. A smooth wall that pushes a ball through between two rough plates, and rough
// plates that drag it against a smooth wall, are one scene seen by two observers: forces and work are the
// same, but for rays that stand at other places of the ball. The mirror image is the same, and plates say
// what they feel along their way. A ball that falls on a belt and slips gets friction times what the belt
// bears.
#include "moving_balls.h"
#include "two_balls.h"

#include <softgrain/base/exceptions.h>

namespace
{
std::string wall(const std::string &name, const std::string &lines)
{
  return "  subsection " + name + "\n" + lines + "  end\n";
}

/// A ball between plates that look along z, before a wall that looks along x. @param side 1; -1: the mirror
/// image
std::string scene(const std::string &of_plates, const std::string &of_stop, const int side = 1)
{
  const std::string left = side > 0 ? "-3" : "-9", right = side > 0 ? "9" : "3";
  return R"(
set Dimension = 3
subsection Mesh
  set Lower = )" +
         left + R"(, -3, -1
  set Upper = )" +
         right + R"(, 3, 6
  set Cell size = 0.8
end
subsection Time
  set Scheme = quasi_static
  set Wall way = 0.1
end
)" + gel("0.4", "1", "1000") +
         R"(subsection Bodies
  set Names = a
  subsection a
    set Shape  = sphere
    set Center = )" +
         (side > 0 ? "" : "-") + R"(0.07, -0.11, 2.5
    set Radius = 2.5
  end
end
subsection Walls
  set Names = bottom, top, stop
)" + wall("bottom", "    set Friction = 0.2\n" + of_plates) +
         wall("top", "    set Point = 0, 0, 5\n    set Velocity = t < 1 ? 0.4 : 0\n    set Friction = 0.2\n" +
                         of_plates) +
         wall("stop", "    set Point = " + std::string(side > 0 ? "-2.7" : "2.7") +
                          ", 0, 0\n    set Normal = " + (side > 0 ? "1" : "-1") + ", 0, 0\n" + of_stop) +
         "end\nsubsection Stop\n  set End time = 2\nend\n";
}

struct Slid
{
  Outcome outcome;
  std::vector<WallState<3>> walls;
  double work = 0.;
};

Slid slid(const std::string &text)
{
  std::ofstream("scene.prm") << text;
  const auto model = model_of("scene.prm", {});
  Slid result;
  result.outcome = run(*model, 2., 0.01);
  result.walls = model->walls();
  result.work = model->energies().external_work;
  return result;
}

void on_a_belt()
{
  const double friction = 0.3, gravity = 1e-4, speed = 0.02;
  MovingBalls ball(text_of(1, true), {"Bodies/a/Center=0.1, -0.07, 2.41", "Loads/Gravity=0, 0, -1e-4",
                                      "Walls/bottom/Friction=0.3", "Walls/bottom/Tangential velocity=0.02"});
  const double before = ball.total_energy();
  ball.run(60., [](const StepReport &) {});
  const Body<3> &body = ball.state().bodies[0];
  const dealii::Tensor<1, 3> given = body.momentum();
  const double borne = given[2] + body.mass.sum() * gravity * ball.model->time();
  std::cout << "on a belt: velocity over that of the belt " << ball.velocity(0)[0] / speed
            << ", friction over what is borne " << given[0] / borne / friction << ", aside "
            << below(0.02, given[1] / given[0]) << ", energy "
            << below(1e-2, (ball.total_energy() - before) / ball.model->energies().kinetic) << '\n';
}
} // namespace

int main()
{
  const std::string along = "    set Tangential velocity = t < 1 ? 0 : -1\n",
                    back = "    set Tangential velocity = t < 1 ? 0 : 1\n";
  const Slid pushed = slid(scene("", "    set Velocity = t < 1 ? 0 : 1\n")), dragged = slid(scene(along, "")),
             image = slid(scene(back, "", -1));
  std::cout << "dragged, not pushed: off by " << below(0.02, off(pushed.outcome, dragged.outcome, {0, 1, 2}))
            << ", work by " << below(0.02, dragged.work / pushed.work - 1.) << '\n';
  for (unsigned int w = 0; w < 2; ++w)
    std::cout << "friction of a plate over what it bears "
              << dragged.walls[w].tangential_force / dragged.walls[w].normal_force << '\n';
  std::cout << "smooth wall " << below(1e-12, dragged.walls[2].tangential_force) << '\n'
            << "mirror image: off by " << below(1e-7, off(dragged.outcome, image.outcome, {0, 1, 2}))
            << ", friction by "
            << below(1e-7, dragged.walls[1].tangential_force / image.walls[1].tangential_force + 1.)
            << ", energy by " << below(0.03, dragged.outcome.energy) << '\n';
  on_a_belt();
  try
  {
    std::ofstream("scene.prm") << text_of(1, true);
    model_of("scene.prm", {"Bodies/a/Center=0, 0, 2.5", "Walls/bottom/Tangential velocity=1"});
  }
  catch (const softgrain::InputError &error)
  {
    std::cout << error.what() << '\n';
  }
}
