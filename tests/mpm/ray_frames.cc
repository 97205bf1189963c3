// SPDX-License-Identifier: LGPL-2.1-or-later
// Frames of contacts of deformed disks, a wall, a corner, and obstacles with a curved side and a tip. A frame
// moves with the mean motion of what lies under its rays. What its rays do to the nodes is the derivative of
// their gaps, and the matrix of Newton's method is the derivative of that: both against differences, with the
// motion of the frame counted in. Forces on both sides are equal and opposite.
#include "frame_derivatives.h"
#include "gel.h"

#include <softgrain/mpm/contact/frame_memory.h>
#include <softgrain/mpm/contact/obstacle_line.h>

#include <iostream>

using namespace softgrain;
using namespace softgrain::mpm;

namespace
{
const std::string text = R"(
subsection Mesh
  set Lower = 0, 0
  set Upper = 14, 9
  set Cell size = 1
end
subsection Time
  set Scheme = quasi_static
end
)" + gel("0.3", "1e4", "1000") +
                         R"(subsection Bodies
  set Names = a, b, square
  subsection a
    set Center = 3.13, 3.91
    set Radius = 2.3
  end
  subsection b
    set Center = 7.83, 4.17
    set Radius = 2.4
  end
  subsection square
    set Shape  = polygon
    set Vertices = 10.4, 4.2; 13, 2; 13, 6.4
  end
end
subsection Walls
  set Names = bottom
  subsection bottom
    set Point = 0, 1.55
  end
end
subsection Stop
  set End time = 1
end
)";

/// Both bodies of a frame are carried along: what that does to gaps and slides, and to the force on the
/// nodes, as far as the frame stays, against differences.
void carry(const std::string &name,
           FrameScene<2> scene,
           const Vectors &start,
           const ContactFrame<2> &frame,
           const Vectors &here)
{
  using Vector = dealii::Tensor<1, 2>;
  constexpr double little = 1e-5;
  const Vector ways[] = {Vector({0.7, -0.4}), Vector({-0.2, 0.9}), Vector({0.5, 0.6})}; // of the bodies
  std::array<Vector, 2> moves;
  for (unsigned int side = 0; side < 2; ++side)
    if (const unsigned int b = side == 0 ? frame.partner : frame.body; b != ContactFrame<2>::none)
      moves[side] = ways[b];
  scene.ways.carried.assign(start.size(), Vector());
  Contact<2> contact(scene, start, frame);
  contact.go(here);
  const FrameState<2> at = contact.frame;
  double gap = 0., difference = 0., slide = 0., slid = 0.;
  for (unsigned int k = 0; k < contact.forces.size(); ++k)
  {
    gap += contact.forces[k] *
           (at.derivatives().gap_by(k, moves) + at.ray(k).by_motion * at.derivatives().motion_by(moves));
    slide += at.derivatives().slide_by(k, moves)[0];
  }
  for (const double sign : {1., -1.})
  {
    for (unsigned int b = 0; b < start.size(); ++b)
      scene.ways.carried[b] = sign * little * ways[b];
    contact.go(here);
    difference += sign / (2. * little) * contact.gaps();
    for (unsigned int k = 0; k < contact.forces.size(); ++k)
      slid += sign / (2. * little) * contact.frame.ray(k).rub.slide[0];
  }
  std::cout << name << ": carried, gaps off by " << below(1e-7, std::abs(gap / difference - 1.))
            << ", slides by " << below(1e-7, std::abs(slide - slid)) << '\n';
}

} // namespace

int main()
{
  const auto model = scene_of_text(text);
  const std::vector<Body<2>> &bodies = model->bodies();
  std::vector<OutlineSurface> outlines;
  std::vector<ContactFrame<2>> none;
  renew_outlines(bodies, outlines, none);
  const std::vector<WallMotion<2>> walls{
      {dealii::Point<2>(0, 1.55), dealii::Tensor<1, 2>({0., 1.}), 0., true}};
  Scene<2> rough; // bodies and walls rub
  rough.bodies.resize(bodies.size());
  rough.walls.resize(1);
  rough.materials.resize(1);
  rough.friction = rough.walls[0].friction = 0.5;
  const ContactPairs pairs(rough);
  // A rigid arc that bulges towards the first body, and the tip of a line beside it.
  Obstacle<2> arc, line;
  arc.description.pieces = {Curve::arc({-0.3, 4.}, 1., -1., 1.)};
  line.description.pieces = {Curve::segment({2.6, 8.}, {2.9, 6.3})};
  AllRigidRays<2> obstacles;
  for (const Obstacle<2> *obstacle : {&arc, &line})
    obstacles.push_back(std::make_unique<ObstacleLine>(*obstacle, 0.5));
  FrameScene<2> scene{bodies, outlines, walls, 1., {}, 0.5, &pairs, nullptr, 0., {}};
  scene.lines = &obstacles;
  Vectors start;
  for (const Body<2> &body : bodies)
    start.push_back(body.nodes.displacement);
  for (const ContactFrame<2> &frame : find_frames(scene, {}))
  {
    const std::string partner = scene.line_of(frame) != nullptr          ? "obstacle"
                                : frame.partner == ContactFrame<2>::none ? "wall"
                                                                         : bodies[frame.partner].name;
    const std::string pair = bodies[frame.body].name + " at " + partner +
                             (frame.corner == ContactFrame<2>::none ? "" : ", corner");
    look(bodies[frame.body].name + " at " + partner +
             (frame.corner == ContactFrame<2>::none ? "" : ", corner"),
         Contact<2>(scene, start, frame), bodies);
    carry(pair, scene, start, frame, changes(bodies, 5, 0.02));
  }
}
