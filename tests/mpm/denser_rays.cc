// SPDX-License-Identifier: LGPL-2.1-or-later
// Rays get denser where outlines lie in each other between them: their places and forces stay, the spacing is
// halved twice at most, and no other frame changes.
#include <softgrain/mpm/contact/denser_rays.h>

#include <cmath>
#include <iostream>
#include <string>

using namespace softgrain;
using mpm::Meeting;
using Frame = mpm::ContactFrame<2>;

namespace
{
constexpr double cell = 2e-3;
constexpr unsigned int n_walls = 4;

/// Five rays half a cell apart, about the origin.
Frame frame_between(const unsigned int body, const unsigned int partner, const unsigned int wall)
{
  Frame frame;
  frame.body = body;
  frame.partner = partner;
  frame.wall = wall;
  turn(frame, dealii::Tensor<1, 2>({0., 1.}));
  frame.spacing = 0.5 * cell;
  for (const int k : {-2, -1, 0, 1, 2})
  {
    Frame::RayPlace ray;
    ray.index = {{k}};
    ray.force = 10. + k;
    frame.rays.push_back(ray);
  }
  return frame;
}

mpm::Verdict overlap(const Meeting &meeting, const double cells)
{
  mpm::Verdict verdict;
  verdict.take(Intrusion{cells * cell, dealii::Point<2>()}, meeting);
  return verdict;
}

/// Spacings of the frames after it, in cells.
void show(const std::string &what, const mpm::Verdict &verdict, std::vector<Frame> &frames)
{
  lay_denser_rays(verdict, n_walls, cell, frames);
  std::cout << what << ':';
  for (const Frame &frame : frames)
    std::cout << ' ' << frame.spacing / cell;
  std::cout << '\n';
}
} // namespace

int main()
{
  constexpr unsigned int none = Frame::none;
  const std::vector<Frame> before = {frame_between(1, 0, none), frame_between(2, 0, none),
                                     frame_between(1, none, 3), frame_between(1, none, n_walls + 3)};
  std::vector<Frame> frames = before;
  using With = Meeting::With;
  show("shallow", overlap({With::body, 0, 1}, 0.04), frames);
  show("two bodies", overlap({With::body, 0, 1}, 0.06), frames);
  show("told by the other one", overlap({With::body, 1, 0}, 0.06), frames);
  show("dense enough", overlap({With::body, 1, 0}, 0.06), frames);
  mpm::Verdict both = overlap({With::wall, 1, 3}, 0.06);
  both.take(overlap({With::obstacle, 1, 3}, 0.055));
  both.take(overlap({With::body, 2, 0}, 0.045));
  show("a wall and an obstacle", mpm::Verdict::of(both.numbers()), frames);

  double moved = 0., changed = 0.;
  for (unsigned int f = 0; f < frames.size(); ++f)
    for (unsigned int k = 0; k < 5; ++k)
    {
      const auto &ray = frames[f].rays[k], &old = before[f].rays[k];
      moved = std::max(moved, (frames[f].offset(ray.index) - before[f].offset(old.index)).norm());
      changed = std::max(changed, std::abs(ray.force - old.force));
    }
  std::cout << "rays moved by " << moved << " m, forces changed by " << changed << " N/m\n";

  std::vector<Frame> corner(1, frame_between(1, 0, none));
  corner[0].corner = 0;
  show("the ray of a corner", overlap({With::body, 0, 1}, 0.06), corner);
}
