// SPDX-License-Identifier: LGPL-2.1-or-later
// Walls that slide in space. A smooth wall that pushes a ball through between two rough plates, and rough
// plates that drag it against a smooth wall, are one scene seen by two observers: forces and work are the
// same. So are those of the scene with its axes exchanged, and plates that slide say what they feel along
// their way. A ball that falls on a belt and slips gets friction times its weight.
#include "moving_balls.h"
#include "two_balls.h"

#include <softgrain/base/exceptions.h>

namespace
{
using Changes = std::vector<std::string>;

std::string wall(const std::string &name, const std::string &lines)
{
  return "  subsection " + name + "\n" + lines + "  end\n";
}

const std::string pressing = "    set Velocity = t < 1 ? 0.4 : 0\n    set Friction = 0.2\n",
                  sliding = "    set Tangential velocity = t < 1 ? 0 : -1\n";

/// A ball between plates that look along z, before a wall that looks along x.
std::string scene(const std::string &of_bottom, const std::string &of_top, const std::string &of_left)
{
  return R"(
set Dimension = 3
subsection Mesh
  set Lower = -3, -3, -1
  set Upper = 9, 3, 6
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
    set Center = 0.07, -0.11, 2.5
    set Radius = 2.5
  end
end
subsection Walls
  set Names = bottom, top, left
)" + wall("bottom", "    set Friction = 0.2\n" + of_bottom) +
         wall("top", "    set Point = 0, 0, 5\n" + pressing + of_top) +
         wall("left", "    set Point = -2.7, 0, 0\n" + of_left) +
         "end\nsubsection Stop\n  set End time = 2\nend\n";
}

/// The dragged ball with y for x and x for z: plates that look along x slide along y.
std::string exchanged()
{
  return R"(
set Dimension = 3
subsection Mesh
  set Lower = -1, -3, -3
  set Upper = 6, 9, 3
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
    set Center = 2.5, 0.07, -0.11
    set Radius = 2.5
  end
end
subsection Walls
  set Names = left, right, front
)" + wall("left", "    set Friction = 0.2\n" + sliding) +
         wall("right", "    set Point = 5, 0, 0\n" + pressing + sliding) +
         wall("front", "    set Point = 0, -2.7, 0\n") + "end\nsubsection Stop\n  set End time = 2\nend\n";
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
  const Slid pushed = slid(scene("", "", "    set Velocity = t < 1 ? 0 : 1\n")),
             dragged = slid(scene(sliding, sliding, ""));
  std::cout << "dragged, not pushed: off by " << below(1e-3, off(pushed.outcome, dragged.outcome, {0, 1, 2}))
            << ", work by " << below(1e-3, dragged.work / pushed.work - 1.) << '\n';
  for (unsigned int w = 0; w < 2; ++w)
    std::cout << "friction of a plate over what it bears "
              << dragged.walls[w].tangential_force / dragged.walls[w].normal_force << '\n';
  std::cout << "smooth wall " << below(1e-12, dragged.walls[2].tangential_force) << '\n';
  std::cout << "other axes: off by "
            << below(1e-7, off(dragged.outcome, slid(exchanged()).outcome, {0, 1, 2})) << '\n';
  on_a_belt();
  try
  {
    std::ofstream("scene.prm") << text_of(1, true);
    model_of("scene.prm", {"Walls/bottom/Tangential velocity=1"});
  }
  catch (const softgrain::InputError &error)
  {
    std::cout << error.what() << '\n';
  }
}
