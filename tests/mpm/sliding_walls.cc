// SPDX-License-Identifier: LGPL-2.1-or-later
// Walls that slide in space. A smooth wall that pushes a ball through between two rough plates, and rough
// plates that drag it against a smooth wall, are one scene seen by two observers: forces and work are the
// same, but for rays that stand at other places of the ball. The mirror image is the same, and plates say
// what they feel along their way. A ball that falls on a belt and slips gets friction times what the belt
// bears.
#include "moving_balls.h"
#include "pushed_ball.h"
#include "two_balls.h"

#include <softgrain/base/exceptions.h>

namespace
{
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
  const dealii::Tensor<1, 3> given = body.nodes.momentum();
  const double borne = given[2] + body.nodes.mass.sum() * gravity * ball.model->time();
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
  const Slid pushed = slid(pushed_ball("", "    set Velocity = t < 1 ? 0 : 1\n")),
             dragged = slid(pushed_ball(along, "")), image = slid(pushed_ball(back, "", -1));
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
