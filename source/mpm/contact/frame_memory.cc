// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/partner_numbers.h>
#include <softgrain/base/parallel.h>
#include <softgrain/model/state_file.h>
#include <softgrain/mpm/contact/frame_memory.h>
#include <softgrain/mpm/contact/rigid_rays.h>

#include <algorithm>
#include <limits>

namespace softgrain::mpm
{
namespace
{
using Frame = ContactFrame<2>;

constexpr unsigned int numbers_of_frame = 7, numbers_of_ray = 5; ///< that are not whole
constexpr unsigned int counts_of_frame = 10, counts_of_ray = 2;

OutlineSurface outline_of(const Body<2> &body)
{
  return {body.boundary.grid_position, body.boundary.loop_start, body.boundary.corner};
}

unsigned int of_side(const Frame &frame, const unsigned int side)
{
  return side == 0 ? frame.partner : frame.body;
}

/// What rays of frames lie on.
struct Surfaces
{
  Surfaces(const std::vector<Body<2>> &bodies,
           const unsigned int n_walls,
           const std::vector<Obstacle<2>> &obstacles)
      : n_walls(n_walls), lines(rays_of(obstacles, std::numeric_limits<double>::max()))
  {
    for (const Body<2> &body : bodies)
      outlines.push_back(outline_of(body));
  }

  unsigned int n_walls;
  std::vector<OutlineSurface> outlines; ///< of bodies
  AllRigidRays<2> lines;                ///< of obstacles, which count on after the walls
};

/// The lists of save_frames() in a state that is read. Every function refuses what cannot be.
class FrameLists
{
public:
  FrameLists(const StateReader &in, const std::string &name)
      : in(in)
      , name(name)
      , who(in.read_integers(name + "/who", ListSize::rows_of(counts_of_frame)))
      , pieces(in.read_integers(name + "/pieces", ListSize::rows_of(counts_of_ray)))
      , where(in.read_doubles(name + "/where", n_frames() * numbers_of_frame))
      , rays(in.read_doubles(name + "/rays", n_rays() * numbers_of_ray))
  {
    if (in.contains(name + "/adhesion"))
      adhesion = in.read_doubles(name + "/adhesion", 2 * n_rays());
  }

  std::size_t n_frames() const { return who.size() / counts_of_frame; }
  std::size_t n_rays() const { return pieces.size() / counts_of_ray; }
  std::size_t n_rays_of(const std::size_t f) const { return who[counts_of_frame * f + 3]; }
  /// Frame @p f without its rays.
  Frame frame(std::size_t f, const Surfaces &surfaces) const;
  /// Ray @p r of all, which is one of @p frame.
  Frame::RayPlace ray(std::size_t r, const Frame &frame, const Surfaces &surfaces) const;

private:
  const StateReader &in;
  const std::string &name;
  std::vector<std::uint64_t> who, pieces;
  std::vector<double> where, rays, adhesion; ///< the last is empty where nothing adheres
};

Frame FrameLists::frame(const std::size_t f, const Surfaces &surfaces) const
{
  const std::uint64_t *names = &who[counts_of_frame * f];
  const std::size_t n_bodies = surfaces.outlines.size();
  const bool at_wall = names[1] == Frame::none;
  if (names[0] >= n_bodies ||
      (at_wall ? names[2] >= surfaces.n_walls + surfaces.lines.size() : names[1] >= n_bodies))
    in.refuse(name + "/who", "there is no such body, wall or obstacle");
  if (names[4] > 1 && names[4] != Frame::none)
    in.refuse(name + "/who", "a frame has two sides");
  Frame frame;
  frame.body = names[0];
  frame.partner = names[1];
  frame.corner = names[4];
  frame.id = names[5];
  for (unsigned int d = 0; d < 2; ++d)
  {
    frame.image[d] = static_cast<int>(names[6 + d]);
    frame.home[d] = static_cast<int>(names[8 + d]);
  }
  frame.wall = at_wall ? names[2] : Frame::none;
  const double *numbers = &where[numbers_of_frame * f];
  frame.origin = dealii::Point<2>(numbers[0], numbers[1]);
  frame.direction = dealii::Tensor<1, 2>({numbers[2], numbers[3]});
  frame.across[0] = dealii::Tensor<1, 2>({frame.direction[1], -frame.direction[0]});
  frame.spacing = numbers[4];
  frame.log_full_width = {{numbers[5], numbers[6]}};
  return frame;
}

Frame::RayPlace FrameLists::ray(const std::size_t r, const Frame &frame, const Surfaces &surfaces) const
{
  Frame::RayPlace ray;
  const std::uint64_t *piece = &pieces[counts_of_ray * r];
  const double *numbers = &rays[numbers_of_ray * r];
  ray.index[0] = static_cast<int>(numbers[0]);
  ray.force = numbers[1];
  ray.friction[0] = numbers[2];
  if (!adhesion.empty())
  {
    ray.pull = adhesion[2 * r];
    ray.memory = adhesion[2 * r + 1];
  }
  if (frame.partner == Frame::none && PartnerNumbers(surfaces.n_walls).is_obstacle(frame.wall))
  {
    const auto &line = surfaces.lines[PartnerNumbers(surfaces.n_walls).obstacle(frame.wall)];
    const std::optional<SurfacePlace<2>> place = line->place_at(piece[0], numbers[3]);
    if (!place)
      in.refuse(name + "/pieces", "the obstacle has no such piece");
    ray.place[0] = *place;
  }
  for (unsigned int side = 0; side < 2; ++side)
    if (const unsigned int b = of_side(frame, side); b != Frame::none)
    {
      if (piece[side] >= surfaces.outlines[b].n_pieces())
        in.refuse(name + "/pieces", "the outline has no such piece");
      ray.place[side] = surfaces.outlines[b].at(piece[side], numbers[3 + side]);
    }
  return ray;
}
} // namespace

void save_frames(StateWriter &out,
                 const std::string &name,
                 const std::vector<Frame> &frames,
                 const bool adhere)
{
  std::vector<double> adhesion;
  std::vector<std::uint64_t> who, pieces;
  std::vector<double> where, rays;
  for (const Frame &frame : frames)
  {
    who.insert(who.end(), {frame.body, frame.partner, frame.wall, frame.rays.size(), frame.corner, frame.id});
    for (const auto &image : {frame.image, frame.home})
      who.insert(who.end(), {static_cast<std::uint64_t>(image[0]), static_cast<std::uint64_t>(image[1])});
    for (unsigned int d = 0; d < 2; ++d)
      where.push_back(frame.origin[d]);
    for (unsigned int d = 0; d < 2; ++d)
      where.push_back(frame.direction[d]);
    where.insert(where.end(), {frame.spacing, frame.log_full_width[0], frame.log_full_width[1]});
    for (const Frame::RayPlace &ray : frame.rays)
    {
      pieces.insert(pieces.end(), {ray.place[0].piece, ray.place[1].piece});
      rays.insert(rays.end(), {static_cast<double>(ray.index[0]), ray.force, ray.friction[0],
                               ray.place[0].along, ray.place[1].along});
      adhesion.insert(adhesion.end(), {ray.pull, ray.memory});
    }
  }
  out.write(name + "/who", who);
  out.write(name + "/where", where);
  out.write(name + "/pieces", pieces);
  out.write(name + "/rays", rays);
  if (adhere)
    out.write(name + "/adhesion", adhesion);
}

void load_frames(const StateReader &in,
                 const std::string &name,
                 const std::vector<Body<2>> &bodies,
                 const unsigned int n_walls,
                 const std::vector<Obstacle<2>> &obstacles,
                 std::vector<Frame> &frames)
{
  const FrameLists lists(in, name);
  const Surfaces surfaces(bodies, n_walls, obstacles);
  frames.clear();
  std::size_t next = 0;
  for (std::size_t f = 0; f < lists.n_frames(); ++f)
  {
    frames.push_back(lists.frame(f, surfaces));
    if (lists.n_rays_of(f) > lists.n_rays() - next)
      in.refuse(name + "/who", "frames have more rays than there are");
    for (const std::size_t end = next + lists.n_rays_of(f); next < end; ++next)
      frames.back().rays.push_back(lists.ray(next, frames.back(), surfaces));
  }
  if (next != lists.n_rays())
    in.refuse(name + "/pieces", "there are more rays than frames have");
}

void renew_outlines(const std::vector<Body<2>> &bodies,
                    std::vector<OutlineSurface> &outlines,
                    std::vector<Frame> &frames)
{
  const bool none = outlines.empty();
  outlines.resize(bodies.size());
  std::vector<char> is_new(bodies.size(), none);
  std::vector<std::vector<double>> before(bodies.size()); // lengths of pieces
  parallel_for(bodies.size(), 4,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t b = begin; b < end; ++b)
                 {
                   const auto &vertex = bodies[b].boundary.grid_position;
                   for (unsigned int m = 0; m < vertex.size() && !is_new[b]; ++m)
                     is_new[b] = outlines[b].at(m, 0.).position != vertex[m];
                   if (!is_new[b])
                     continue;
                   if (!none)
                     for (unsigned int m = 0; m < vertex.size(); ++m)
                       before[b].push_back(outlines[b].length(m));
                   outlines[b] = outline_of(bodies[b]);
                 }
               });
  if (none)
    return; // places of frames are those of these outlines
  for (Frame &frame : frames)
    for (unsigned int side = 0; side < 2; ++side)
      if (const unsigned int b = of_side(frame, side); b != Frame::none && is_new[b])
        for (Frame::RayPlace &ray : frame.rays)
        {
          const SurfacePlace<2> &place = ray.place[side];
          ray.place[side] = outlines[b].at(place.piece, place.along * outlines[b].length(place.piece) /
                                                            before[b][place.piece]);
        }
}
} // namespace softgrain::mpm
