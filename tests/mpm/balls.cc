// SPDX-License-Identifier: LGPL-2.1-or-later
// Two balls of different size, one above the other beside the axis of a box that becomes lower, and the eight
// balls of the gallery with two cells in their radius, pressed until they fill nine tenths of their box.
// Every state is in balance: forces on each ball add up to nothing, opposite walls feel the same, and what
// walls do is stored. The mirror image of the two balls, the same with their names exchanged, and with two
// threads, is the same.
#include "gel.h"
#include "scene_of.h"

#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/model/space_model.h>

#include <iostream>
#include <map>

using namespace softgrain;
using namespace softgrain::mpm;

namespace
{
const std::string two = R"(
set Dimension = 3
subsection Mesh
  set Lower = -6, -6, -1
  set Upper = 6, 6, 11
  set Cell size = 1
end
subsection Time
  set Scheme = quasi_static
  set Wall way = 0.3
end
)" + gel("0.4", "1", "1000") +
                        R"(subsection Bodies
  set Names = a, b
  subsection a
    set Shape  = sphere
    set Center = 0.12, -0.08, 2.4
    set Radius = 2.3
  end
  subsection b
    set Shape  = sphere
    set Center = -0.21, 0.13, 7.3
    set Radius = 2.5
  end
end
subsection Walls
  set Names = bottom, top, left, right, front, back
  subsection bottom
    set Point = 0, 0, 0
  end
  subsection top
    set Point = 0, 0, 10
    set Velocity = 1
  end
  subsection left
    set Point = -2.8, 0, 0
  end
  subsection right
    set Point = 2.8, 0, 0
  end
  subsection front
    set Point = 0, -2.8, 0
  end
  subsection back
    set Point = 0, 2.8, 0
  end
end
subsection Stop
  set End time = 2.5
end
)";

std::unique_ptr<Model<3>> model_of(const std::string &file, std::vector<std::string> changes)
{
  changes.insert(changes.begin(), "Output directory=results");
  Input input(file, changes);
  return input.create_model_in_space();
}

const SpaceState &state_of(const Model<3> &model)
{
  return dynamic_cast<const SpaceModel &>(model).space();
}

/// The largest force that is left over on a ball, over the mean force of a contact, or over a force that
/// counts, see unbalanced_rays().
double left_over(const SpaceState &state, const double counts)
{
  std::vector<dealii::Tensor<1, 3>> net(state.bodies.size());
  std::map<std::array<unsigned int, 3>, dealii::Tensor<1, 3>> pairs;
  for (const SpaceContact &contact : state.contacts)
  {
    net[contact.body] += contact.force;
    if (contact.partner != ContactFrame<3>::none)
      net[contact.partner] -= contact.force;
    pairs[{{contact.body, contact.partner, contact.wall}}] += contact.force;
  }
  double worst = 0., mean = 0.;
  for (const auto &[who, force] : pairs)
    mean += force.norm() / pairs.size();
  for (const auto &force : net)
    worst = std::max(worst, force.norm());
  return worst / std::max(mean, counts);
}

/// What a run comes to.
struct Outcome
{
  std::vector<double> forces; ///< on the walls
  unsigned int steps = 0, iterations = 0;
  double left_over = 0., energy = 0., coordination = 0.;
};

/// @param counts force that counts, a hundredth of Young's modulus times the side of a cell
Outcome run(Model<3> &model, const double end, const double counts)
{
  Outcome outcome;
  while (model.time() < end * (1. - 1e-12))
  {
    StepReport report = model.advance(end - model.time());
    model.settle(report);
    ++outcome.steps;
    outcome.iterations += report.newton_iterations;
    outcome.left_over = std::max(outcome.left_over, left_over(state_of(model), counts));
  }
  for (const WallState<3> &wall : model.walls())
    outcome.forces.push_back(wall.normal_force);
  const Energies energies = model.energies();
  outcome.energy = (energies.elastic + energies.dissipated) / energies.external_work - 1.;
  outcome.coordination = model.coordination();
  return outcome;
}

double off(const Outcome &a, const Outcome &b, const std::vector<unsigned int> &walls)
{
  double worst = 0.;
  for (unsigned int w = 0; w < walls.size(); ++w)
    worst = std::max(worst, std::abs(a.forces[w] - b.forces[walls[w]]) / a.forces[1]);
  return worst;
}

Outcome two_balls(const std::vector<std::string> &changes)
{
  std::ofstream("scene.prm") << two;
  const auto model = model_of("scene.prm", changes);
  return run(*model, 2.5, 0.01);
}
} // namespace

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
      before = state_of(*failing).bodies[0].displacement;
      StepReport report = failing->advance(0.3);
      failing->settle(report);
    }
  }
  catch (const ComputationError &)
  {
    std::cout << "given up, state as before "
              << (failing->time() == time && state_of(*failing).bodies[0].displacement == before) << '\n';
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
            << below(0.05, full.energy) << ", less than 16 iterations a step "
            << (full.iterations < 16 * full.steps) << '\n';
}
