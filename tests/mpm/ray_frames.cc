// SPDX-License-Identifier: LGPL-2.1-or-later
// Frames of contacts of deformed disks, a wall, a corner, and obstacles with a curved side and a tip. A frame
// moves with the mean motion of what lies under its rays. What its rays do to the nodes is the derivative of
// their gaps, and the matrix of Newton's method is the derivative of that: both against differences, with the
// motion of the frame counted in. Forces on both sides are equal and opposite.
#include "scene_of.h"

#include <softgrain/mpm/contact/frame_memory.h>
#include <softgrain/mpm/contact/frame_state.h>

#include <iostream>
#include <random>

using namespace softgrain;
using namespace softgrain::mpm;

namespace
{
using Vectors = std::vector<Eigen::VectorXd>;

const std::string text = R"(
subsection Mesh
  set Lower = 0, 0
  set Upper = 14, 9
  set Cell size = 1
end
subsection Time
  set Scheme = quasi_static
end
subsection Materials
  set Names = gel
  subsection gel
    set Law     = neo_hookean
    set Density = 1000
    subsection Neo-Hookean
      set Young's modulus = 1e4
      set Poisson's ratio = 0.3
    end
  end
end
subsection Bodies
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

/// Adds vectors of nodes to those of a body.
struct Into
{
  Eigen::VectorXd &nodal;
  void operator()(const unsigned int node, const dealii::Tensor<1, 2> &value) const
  {
    for (unsigned int d = 0; d < 2; ++d)
      nodal[2 * node + d] += value[d];
  }
};

class Contact
{
public:
  Contact(const FrameScene<2> &scene, const Vectors &at_start, ContactFrame<2> frame)
      : scene(scene), start(at_start), forces(frame.rays.size(), 0.7), frame(frame, scene)
  {
    for (unsigned int k = 0; k < forces.size(); ++k)
      forces[k] += 0.3 * k;
  }

  /// Whether all rays are met after the nodes have moved by @p way.
  bool go(const Vectors &way)
  {
    Vectors displacement = start;
    for (unsigned int b = 0; b < way.size(); ++b)
      displacement[b] += way[b];
    frame.prepare(scene, way, forces, 1., 1e9);
    frame.look(scene, displacement, way, {}, forces);
    return frame.meets(forces);
  }

  double gaps() const
  {
    double sum = 0.;
    for (unsigned int k = 0; k < forces.size(); ++k)
      sum += forces[k] * frame.ray(k).gap;
    return sum;
  }

  /// Force on the nodes of all bodies: the derivative of gaps().
  Vectors force() const
  {
    Vectors result(start.size());
    for (unsigned int b = 0; b < start.size(); ++b)
      result[b].setZero(start[b].size());
    for (unsigned int side = 0; side < 2; ++side)
      if (const unsigned int b = frame.body(side); b != FrameState<2>::none)
      {
        for (unsigned int k = 0; k < forces.size(); ++k)
          frame.for_gradient(k, side, forces[k], Into{result[b]});
        frame.for_mean(side, 0, -frame.tangential(forces)[0], Into{result[b]});
      }
    return result;
  }

  /// Its change for a little way, by second derivatives.
  Vectors change(const Vectors &way) const
  {
    Vectors mixed(start.size()), mean(start.size()), result(start.size());
    double moves = 0., by_mixed = 0.;
    for (unsigned int b = 0; b < start.size(); ++b)
      for (Vectors *each : {&mixed, &mean, &result})
        (*each)[b].setZero(start[b].size());
    for (unsigned int side = 0; side < 2; ++side)
      if (const unsigned int b = frame.body(side); b != FrameState<2>::none)
      {
        frame.for_mixed(side, forces, frame.as_motion(0), Into{mixed[b]});
        frame.for_mean(side, 0, 1., Into{mean[b]});
        for (unsigned int k = 0; k < forces.size(); ++k)
          frame.ray(k).side[side].second_derivative(
              [&](const unsigned int i, const unsigned int j, const dealii::Tensor<2, 2> &block)
              {
                const double factor = (side == 0 ? -1. : 1.) * forces[k];
                for (unsigned int d = 0; d < 2; ++d)
                  for (unsigned int e = 0; e < 2; ++e)
                    result[b][2 * i + d] += factor * block[d][e] * way[b][2 * j + e];
              });
      }
    for (unsigned int b = 0; b < start.size(); ++b)
    {
      moves += mean[b].dot(way[b]);
      by_mixed += mixed[b].dot(way[b]);
    }
    for (unsigned int b = 0; b < start.size(); ++b)
      result[b] += moves * mixed[b] + (by_mixed + frame.twice_by_motion(forces, 0, 0) * moves) * mean[b];
    return result;
  }

  const FrameScene<2> &scene;
  const Vectors start;
  std::vector<double> forces;
  FrameState<2> frame;
};

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
  scene.carried.assign(start.size(), Vector());
  Contact contact(scene, start, frame);
  contact.go(here);
  const FrameState<2> at = contact.frame;
  double gap = 0., difference = 0., slide = 0., slid = 0.;
  for (unsigned int k = 0; k < contact.forces.size(); ++k)
  {
    gap += contact.forces[k] * (at.gap_by(k, moves) + at.ray(k).by_motion * at.motion_by(moves));
    slide += at.slide_by(k, moves);
  }
  for (const double sign : {1., -1.})
  {
    for (unsigned int b = 0; b < start.size(); ++b)
      scene.carried[b] = sign * little * ways[b];
    contact.go(here);
    difference += sign / (2. * little) * contact.gaps();
    for (unsigned int k = 0; k < contact.forces.size(); ++k)
      slid += sign / (2. * little) * contact.frame.ray(k).slide;
  }
  std::cout << name << ": carried, gaps off by " << below(1e-7, std::abs(gap / difference - 1.))
            << ", slides by " << below(1e-7, std::abs(slide - slid)) << '\n';
}

double dot(const Vectors &a, const Vectors &b)
{
  double sum = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
    sum += a[i].dot(b[i]);
  return sum;
}

Vectors sum(const Vectors &a, const double factor, const Vectors &b)
{
  Vectors result = a;
  for (unsigned int i = 0; i < a.size(); ++i)
    result[i] += factor * b[i];
  return result;
}

/// Smooth changes of the nodes.
Vectors changes(const std::vector<Body<2>> &bodies, const unsigned int seed, const double size)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1., 1.);
  Vectors result;
  for (const Body<2> &body : bodies)
  {
    Eigen::VectorXd of_body(body.field.n_dofs());
    double c[8];
    for (double &each : c)
      each = number(random);
    for (unsigned int i = 0; i < body.field.n_independent(); ++i)
    {
      const auto arm = body.field.position(body.field.node_of_independent(i)) - body.center();
      of_body[2 * i] = size * (c[0] + c[1] * arm[0] + c[2] * arm[1] + std::sin(c[3] * arm[0]));
      of_body[2 * i + 1] = size * (c[4] + c[5] * arm[0] + c[6] * arm[1] + std::sin(c[7] * arm[1]));
    }
    result.push_back(of_body);
  }
  return result;
}

void look(const std::string &name, Contact contact, const std::vector<Body<2>> &bodies)
{
  const Vectors here = changes(bodies, 5, 0.02), way = changes(bodies, 8, 1.);
  constexpr double little = 1e-5;
  const bool met = contact.go(here);
  const Vectors force = contact.force(), change = contact.change(way);
  double net[2] = {0., 0.};
  for (const Eigen::VectorXd &of_body : force)
    for (unsigned int i = 0; i < of_body.size(); ++i)
      net[i % 2] += of_body[i];
  contact.go(sum(here, little, way));
  const double gaps_after = contact.gaps();
  const Vectors after = contact.force();
  contact.go(sum(here, -little, way));
  const double slope = (gaps_after - contact.gaps()) / (2. * little);
  const Vectors difference = sum(after, -1., contact.force());
  const double wrong_force = std::abs(dot(force, way) / slope - 1.);
  const double norm = std::sqrt(dot(change, change)),
               wrong_change = std::sqrt(dot(sum(change, -0.5 / little, difference),
                                            sum(change, -0.5 / little, difference))) /
                              std::max(norm, 1e-3);
  std::cout << name << ": rays " << contact.forces.size() << ", met " << met << ", force off by "
            << below(1e-7, wrong_force) << ", its change by " << below(1e-6, wrong_change)
            << ", net force along the frame "
            << below(1e-12, net[0] * contact.frame.layout().across[0][0] +
                                net[1] * contact.frame.layout().across[0][1])
            << ", has a second derivative " << (norm > 1e-3) << '\n';
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
  Obstacle arc, line;
  arc.description.pieces = {Curve::arc({-0.3, 4.}, 1., -1., 1.)};
  line.description.pieces = {Curve::segment({2.6, 8.}, {2.9, 6.3})};
  const std::vector<ObstacleLine> obstacles{ObstacleLine(arc), ObstacleLine(line)};
  FrameScene<2> scene{bodies, outlines, walls, 1., {}, 0.5, &pairs, nullptr, 0., {}};
  scene.lines = &obstacles;
  Vectors start;
  for (const Body<2> &body : bodies)
    start.push_back(body.displacement);
  for (const ContactFrame<2> &frame : find_frames(scene, {}))
  {
    const std::string partner = scene.line_of(frame) != nullptr          ? "obstacle"
                                : frame.partner == ContactFrame<2>::none ? "wall"
                                                                         : bodies[frame.partner].name;
    const std::string pair = bodies[frame.body].name + " at " + partner +
                             (frame.corner == ContactFrame<2>::none ? "" : ", corner");
    look(bodies[frame.body].name + " at " + partner +
             (frame.corner == ContactFrame<2>::none ? "" : ", corner"),
         Contact(scene, start, frame), bodies);
    carry(pair, scene, start, frame, changes(bodies, 5, 0.02));
  }
}
