// SPDX-License-Identifier: LGPL-2.1-or-later
// Balls that move in space, and what their motion comes to.
#ifndef softgrain_tests_mpm_moving_balls_h
#define softgrain_tests_mpm_moving_balls_h

#include "gel.h"
#include "space_model_of.h"

#include <iostream>

using namespace softgrain;
using namespace softgrain::mpm;

/// Gel with Young's modulus 1 and density 1, so waves go about 1 a second; balls of radius 2.4 and cells of
/// .8.
constexpr double radius = 2.4, poisson = 0.4;

inline std::string text_of(const unsigned int n_bodies, const bool plane)
{
  std::string text = R"(
set Dimension = 3
subsection Mesh
  set Lower = -100, -100, -100
  set Upper = 100, 100, 100
  set Cell size = 0.8
end
subsection Time
  set Scheme = moreau_jean
  set CFL multiple = 4
end
)" + gel("0.4", "1", "1");
  text += std::string("subsection Bodies\n  set Names = ") + (n_bodies == 1 ? "a" : "a, b") + "\n";
  for (unsigned int b = 0; b < n_bodies; ++b)
    text += std::string("  subsection ") + (b == 0 ? "a" : "b") +
            "\n    set Shape = sphere\n    set Radius = 2.4\n  end\n";
  text += "end\n";
  if (plane)
    text +=
        "subsection Walls\n  set Names = bottom\n  subsection bottom\n    set Point = 0, 0, 0\n  end\nend\n";
  return text + "subsection Stop\n  set End time = 1e9\nend\n";
}

struct MovingBalls
{
  MovingBalls(const std::string &text, const std::vector<std::string> &changes)
  {
    std::ofstream("scene.prm") << text;
    model = model_of("scene.prm", changes);
  }

  const SpaceState &state() const { return state_of(*model); }

  dealii::Tensor<1, 3> velocity(const unsigned int b) const
  {
    return state().bodies[b].nodes.momentum() / state().bodies[b].nodes.mass.sum();
  }
  dealii::Tensor<1, 3> momentum() const
  {
    dealii::Tensor<1, 3> sum;
    for (const Body<3> &body : state().bodies)
      sum += body.nodes.momentum();
    return sum;
  }
  /// Of a body about its centre.
  dealii::Tensor<1, 3> spin(const unsigned int b) const
  {
    const Body<3> &body = state().bodies[b];
    return turning(body, body.center());
  }
  /// Of all about the origin.
  dealii::Tensor<1, 3> angular_momentum() const
  {
    dealii::Tensor<1, 3> sum;
    for (const Body<3> &body : state().bodies)
      sum += turning(body, dealii::Point<3>());
    return sum;
  }
  static dealii::Tensor<1, 3> turning(const Body<3> &body, const dealii::Point<3> &about)
  {
    dealii::Tensor<1, 3> sum;
    for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
    {
      const dealii::Tensor<1, 3> arm =
          body.field.place(i) + PlaceFunctions<3>::of_node(body.nodes.displacement, i) - about;
      sum += body.nodes.mass[i] * cross_product_3d(arm, PlaceFunctions<3>::of_node(body.nodes.velocity, i));
    }
    return sum;
  }
  double total_energy() const
  {
    const Energies e = model->energies();
    return e.kinetic + e.elastic + e.dissipated - e.external_work;
  }
  /// Steps until @p end, calling @p look after each.
  template <class F>
  void run(const double end, const F &look)
  {
    while (model->time() < end * (1. - 1e-12))
    {
      const StepReport report = model->advance(end - model->time());
      iterations += report.newton_iterations;
      attempts += report.attempts;
      ++steps;
      look(report);
    }
  }

  std::unique_ptr<Model<3>> model;
  unsigned int iterations = 0, attempts = 0, steps = 0;
};

#endif
