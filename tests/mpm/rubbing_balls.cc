// SPDX-License-Identifier: LGPL-2.1-or-later
// Balls that rub. Two of them in a box that becomes lower, with friction between all: each is in balance of
// forces and of torques, no contact bears more than its friction, and what walls do is stored or rubbed away.
// The mirror image of the two balls, the same with their names exchanged, and with two threads, is the same
// within what is said below. A ball that two rough plates hold and a smooth wall pushes gives way when both
// bear their friction.
#include "pushed_ball.h"
#include "two_balls.h"

#include <softgrain/base/parallel.h>

namespace
{
/// The largest torque that is left over on a ball about its centre, over force and radius, and the largest
/// share of its friction that a contact bears.
std::pair<double, double> torque_and_friction(const Model<3> &model, const double friction)
{
  const SpaceState &state = state_of(model);
  std::vector<dealii::Tensor<1, 3>> torque(state.bodies.size());
  double largest = 0., share = 0.;
  for (const SpaceContact &contact : state.contacts)
  {
    largest = std::max(largest, contact.force.norm());
    torque[contact.body] +=
        cross_product_3d(contact.place - state.bodies[contact.body].center(), contact.force);
    if (contact.partner != ContactFrame<3>::none)
      torque[contact.partner] -=
          cross_product_3d(contact.place - state.bodies[contact.partner].center(), contact.force);
    else
    {
      const dealii::Tensor<1, 3> normal = model.walls()[contact.wall].normal;
      const double pressed = contact.force * normal;
      share = std::max(share, (contact.force - pressed * normal).norm() / (friction * pressed));
    }
  }
  double worst = 0.;
  for (const auto &of_body : torque)
    worst = std::max(worst, of_body.norm() / (largest * 2.3));
  return {worst, share};
}
} // namespace

int main()
{
  const std::string rough = "Contact/Friction=0.3", all = "Contact/Friction at walls=same";
  std::ofstream("scene.prm") << two;
  const auto model = model_of("scene.prm", {rough, all});
  const Outcome pressed = run(*model, 2.5, 0.01);
  const auto [torque, share] = torque_and_friction(*model, 0.3);
  std::cout << "two balls: balance within 1e-3 " << (pressed.left_over < 1e-3) << ", torque left over "
            << below(2e-2, torque) << ", share of friction " << share << ", energy off by "
            << below(0.03, pressed.energy) << ", less than 16 iterations a step "
            << (pressed.iterations < 16 * pressed.steps) << '\n';
  // On their way the balls rearrange, and which rays slip meanwhile is found in other iterates. Dents that
  // become softer make more of them.
  const std::string first = "Bodies/a/Center=-0.12, -0.08, 2.4", second = "Bodies/b/Center=0.21, 0.13, 7.3",
                    no_dents = "Contact/Sub-grid compliance=false";
  const Outcome image = two_balls({rough, all, first, second});
  std::cout << "mirror image off by " << below(3e-4, off(pressed, image, {0, 1, 3, 2, 4, 5})) << '\n';
  const Outcome without = two_balls({rough, all, no_dents}),
                its_image = two_balls({rough, all, no_dents, first, second});
  std::cout << "without dents by " << below(1e-5, off(without, its_image, {0, 1, 3, 2, 4, 5})) << '\n';
  const Outcome exchanged = two_balls({rough, all, "Bodies/a/Center=-0.21, 0.13, 7.3", "Bodies/a/Radius=2.5",
                                       "Bodies/b/Center=0.12, -0.08, 2.4", "Bodies/b/Radius=2.3"});
  std::cout << "exchanged off by " << below(1e-7, off(pressed, exchanged, {0, 1, 2, 3, 4, 5})) << '\n';
  std::ofstream("ball.prm") << pushed_ball("", "    set Velocity = t < 1 ? 0 : 1\n");
  const auto pushed = model_of("ball.prm", {});
  run(*pushed, 2., 0.01);
  const std::vector<WallState<3>> walls = pushed->walls();
  std::cout << "a ball is pushed by "
            << walls[2].normal_force / (0.2 * (walls[0].normal_force + walls[1].normal_force))
            << " of the friction that it bears\n";
  set_n_threads(2);
  std::cout << "two threads same " << (two_balls({rough, all}).forces == pressed.forces) << '\n';
}
