// SPDX-License-Identifier: LGPL-2.1-or-later
// Two balls of different size, one above the other beside the axis of a box that becomes lower, and the eight
// balls of the gallery with two cells in their radius, pressed until they fill nine tenths of their box.
// Every state is in balance: forces on each ball add up to nothing, opposite walls feel the same, and what
// walls do is stored. The mirror image of the two balls, the same with their names exchanged, and with two
// threads, is the same.
#include "two_balls.h"

#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>

using namespace softgrain;
using namespace softgrain::mpm;

int main()
{
  const Outcome pressed = two_balls({});
  std::cout << "two balls: balance within 1e-3 " << (pressed.left_over < 1e-3) << ", coordination "
            << pressed.coordination << ", less than 8 iterations a step "
            << (pressed.iterations < 8 * pressed.steps) << ", bottom and top off by "
            << below(1e-3, pressed.forces[0] / pressed.forces[1] - 1.) << ", energy off by "
            << below(0.03, pressed.energy) << '\n';
  const Outcome image = two_balls({"Bodies/a/Center=-0.12, -0.08, 2.4", "Bodies/b/Center=0.21, 0.13, 7.3"});
  std::cout << "mirror image off by " << below(1e-7, off(pressed, image, {0, 1, 3, 2, 4, 5})) << '\n';
  const Outcome exchanged = two_balls({"Bodies/a/Center=-0.21, 0.13, 7.3", "Bodies/a/Radius=2.5",
                                       "Bodies/b/Center=0.12, -0.08, 2.4", "Bodies/b/Radius=2.3"});
  std::cout << "exchanged off by " << below(1e-7, off(pressed, exchanged, {0, 1, 2, 3, 4, 5})) << '\n';
  try
  {
    two_balls({"Bodies/b/Center=0, 0, 7"});
  }
  catch (const InputError &error)
  {
    std::cout << "too near: " << error.what() << '\n';
  }
  // A step that is given up in its held steps leaves nothing behind.
  const auto failing =
      model_of("scene.prm", {"Quasi-static/Held steps=1", "Quasi-static/Unbalanced force=1e-12"});
  double time = 0.;
  Eigen::VectorXd before;
  try
  {
    while (time < 2.)
    {
      time = failing->time();
      before = state_of(*failing).bodies[0].nodes.displacement;
      StepReport report = failing->advance(0.3);
      failing->settle(report);
    }
  }
  catch (const ComputationError &)
  {
    std::cout << "given up, state as before "
              << (failing->time() == time && state_of(*failing).bodies[0].nodes.displacement == before)
              << '\n';
  }
  set_n_threads(2);
  std::cout << "two threads same " << (two_balls({}).forces == pressed.forces) << '\n';
  const auto eight =
      model_of(SOFTGRAIN_SOURCE_DIR "/parameters/gallery/eight_spheres.prm", {"Mesh/Cell size=2.4e-3"});
  const Outcome full = run(*eight, 2.2, 0.01 * 10e6 * 2.4e-3 * 2.4e-3);
  double between = 0.;
  for (unsigned int w = 0; w < 6; w += 2)
    between = std::max(between, std::abs(full.forces[w] / full.forces[w + 1] - 1.));
  const double edge = 20e-3 - 2. * 2.2e-3;
  std::cout << "eight balls: balance within 1e-3 " << (full.left_over < 1e-3) << ", coordination "
            << full.coordination << ", fill " << eight->solid_area() / (edge * edge * edge)
            << ", opposite walls off by " << below(1e-3, between) << ", energy off by "
            << below(0.05, full.energy) << ", less than 8 iterations a step "
            << (full.iterations < 8 * full.steps) << '\n';
}
