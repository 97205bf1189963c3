// SPDX-License-Identifier: LGPL-2.1-or-later
// Two balls of different size, one above the other beside the axis of a box that becomes lower, and what runs
// of scenes in space come to.
#ifndef softgrain_tests_mpm_two_balls_h
#define softgrain_tests_mpm_two_balls_h

#include "gel.h"
#include "space_model_of.h"

#include <iostream>
#include <map>

using namespace softgrain;
using namespace softgrain::mpm;

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

/// The largest force that is left over on a ball, over the mean force of a contact, or over a force that
/// counts, see unbalanced_rays().
inline double left_over(const SpaceState &state, const double counts)
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
inline Outcome run(Model<3> &model, const double end, const double counts)
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

inline double off(const Outcome &a, const Outcome &b, const std::vector<unsigned int> &walls)
{
  double worst = 0.;
  for (unsigned int w = 0; w < walls.size(); ++w)
    worst = std::max(worst, std::abs(a.forces[w] - b.forces[walls[w]]) / a.forces[1]);
  return worst;
}

inline Outcome two_balls(const std::vector<std::string> &changes)
{
  std::ofstream("scene.prm") << two;
  const auto model = model_of("scene.prm", changes);
  return run(*model, 2.5, 0.01);
}

#endif
