// SPDX-License-Identifier: LGPL-2.1-or-later
// Frames between balls and at walls, as ray_frames has them in the plane: what rays do to the nodes is the
// derivative of their gaps, and the matrix of Newton's method is the derivative of that, with both components
// of the motion of a frame counted in. Forces on both sides are equal and opposite. Exchanged bodies have the
// same lattice. Newton's matrix has a place for every cell that a surface goes through, also for those
// without material points.
#include "frame_derivatives.h"
#include "gel.h"
#include "space_model_of.h"

#include <softgrain/linear/linear_solver.h>
#include <softgrain/mpm/stepping/space_equations.h>

#include <set>

using namespace softgrain;
using namespace softgrain::mpm;

namespace
{
const std::string text = R"(
set Dimension = 3
subsection Mesh
  set Lower = 0, 0, 0
  set Upper = 12, 7, 7
  set Cell size = 1
end
subsection Time
  set Scheme = quasi_static
  set Wall way = 0.1
end
)" + gel("0.3", "1", "1000") +
                         R"(subsection Bodies
  set Names = a, b
  subsection a
    set Shape  = sphere
    set Center = 3.13, 3.31, 3.42
    set Radius = 2.3
  end
  subsection b
    set Shape  = sphere
    set Center = 7.75, 3.67, 3.97
    set Radius = 2.3
  end
end
subsection Walls
  set Names = bottom
  subsection bottom
    set Point = 0, 0, 1.1
  end
end
subsection Stop
  set End time = 1
end
)";

/// Adds to the matrix of every body in all cells of its surface, which throws where one has no place.
void add_everywhere(const SpaceState &state)
{
  SpaceWorkspace work;
  work.reinit(state.bodies, LinearSolverSettings(), true);
  for (const Body<3> &body : state.bodies)
  {
    std::set<unsigned int> with_points, cells;
    for (const auto &color : body.field.cells().colors())
      with_points.insert(color.begin(), color.end());
    const dealii::Point<3> center = body.center();
    for (unsigned int i = 0; i < 100; ++i)
      for (unsigned int j = 0; j < 100; ++j)
      {
        const double across = std::sqrt(1. - std::pow(0.02 * i - 0.99, 2)), angle = 0.02 * M_PI * j;
        const dealii::Tensor<1, 3> direction(
            {across * std::cos(angle), across * std::sin(angle), 0.02 * i - 0.99});
        cells.insert(
            body.field.functions_at(state.surfaces[body.index].at(center + direction).position).cell);
      }
    unsigned int without = 0;
    for (const unsigned int cell : cells)
    {
      without += with_points.count(cell) == 0;
      work.matrices[body.index].add_cell<3>(
          cell, [](unsigned int, unsigned int, unsigned int, unsigned int) { return 1.; }, 1.);
    }
    std::cout << body.name << ": " << cells.size() << " cells of the surface, " << without
              << " without material points\n";
  }
}
} // namespace

int main()
{
  std::ofstream("scene.prm") << text;
  const auto any = model_of("scene.prm", {});
  const SpaceState &state = state_of(*any);
  const std::vector<WallMotion<3>> walls{
      {dealii::Point<3>(0, 0, 1.1), dealii::Tensor<1, 3>({0., 0., 1.}), 0., true}};
  // The ball on the left reaches into the next cells by so little that no point lies there.
  add_everywhere(state_of(*model_of("scene.prm", {"Bodies/a/Center=2.7002, 3.31, 3.42"})));
  const FrameScene<3> scene{state.bodies, state.surfaces, walls, 1., {}, 0.5};
  Vectors start;
  for (const Body<3> &body : state.bodies)
    start.push_back(body.nodes.displacement);
  for (const ContactFrame<3> &frame : find_frames(scene, {}))
  {
    const std::string partner =
        frame.partner == ContactFrame<3>::none ? "wall" : state.bodies[frame.partner].name;
    look(state.bodies[frame.body].name + " at " + partner, Contact<3>(scene, start, frame), state.bodies);
    ContactFrame<3> swapped = frame;
    turn(swapped, -frame.direction);
    const auto here = frame.offset({{1, 2}}), there = swapped.offset({{3, -2}});
    dealii::Tensor<1, 3> apart;
    for (unsigned int m = 0; m < 2; ++m)
      apart += here[m] * frame.across[m] - there[m] * swapped.across[m];
    std::cout << "a place of the lattice of the exchanged frame is off by " << below(1e-14, apart.norm())
              << '\n';
  }
}
