// SPDX-License-Identifier: LGPL-2.1-or-later
// What owners tell each other of the rays that they have looked along.
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/contact/told_rays.h>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
/// Counts the numbers of a ray.
struct Counter
{
  std::size_t &n;
  template <class Number>
  void operator()(const Number &) const
  {
    ++n;
  }
};

struct Packer
{
  double *&to;
  template <class Number>
  void operator()(const Number &number) const
  {
    *to++ = static_cast<double>(number);
  }
};

struct Unpacker
{
  const double *&from;
  template <class Number>
  void operator()(Number &number) const
  {
    number = static_cast<Number>(*from++);
  }
};

template <int dim, class Part>
void for_place(SurfacePlace<dim> &place, const Part &part)
{
  for (unsigned int d = 0; d < dim; ++d)
  {
    part(place.position[d]);
    part(place.normal[d]);
  }
  for (unsigned int k = 0; k < dim - 1; ++k)
  {
    for (unsigned int d = 0; d < dim; ++d)
      part(place.tangent[k][d]);
    for (unsigned int l = 0; l < dim - 1; ++l)
      part(place.bend[k][l]);
  }
  part(place.piece);
  part(place.along);
  part(place.at_edge);
}

/// Whether a body of the frame is owned.
template <int dim>
bool is_here(const BodyShare &share, const FrameState<dim> &frame)
{
  const unsigned int partner = frame.unknown(0);
  return share.mine(frame.body(1)) || (partner != FrameState<dim>::none && share.mine(partner));
}
} // namespace

/// What looking along the rays of a frame has found, for those who have not looked themselves: numbers of the
/// rays looked at. These know all of a ray but what nodes do to its places.
template <int dim>
class ToldFrame
{
public:
  explicit ToldFrame(FrameState<dim> &state) : state(state) {}

  std::size_t n_told() const
  {
    std::size_t of_ray = 0;
    RayHere<dim> any;
    for_told(any, Counter{of_ray});
    const auto &rays = state.rays;
    return (state.inertia() ? dim + state.beside.size() * of_ray : 0) +
           of_ray * std::count_if(rays.begin(), rays.end(), [](const RayHere<dim> &ray) { return ray.near; });
  }

  void tell(double *numbers)
  {
    if (state.inertia())
    {
      *numbers++ = state.follows;
      for (unsigned int m = 0; m < dim - 1; ++m)
        *numbers++ = state.moved[m];
    }
    for_rays_told(Packer{numbers});
  }

  void take(const double *numbers)
  {
    if (state.inertia())
    {
      state.follows = *numbers++ != 0.;
      for (unsigned int m = 0; m < dim - 1; ++m)
        state.moved[m] = *numbers++;
    }
    for_rays_told(Unpacker{numbers});
  }

private:
  template <class Part>
  void for_rays_told(const Part &part)
  {
    if (state.inertia())
      for (RayHere<dim> &ray : state.beside)
        for_told(ray, part);
    for (RayHere<dim> &ray : state.rays)
      if (ray.near)
        for_told(ray, part);
  }

  template <class Part>
  void for_told(RayHere<dim> &ray, const Part &part) const
  {
    part(ray.met);
    part(ray.gap);
    for (unsigned int m = 0; m < dim - 1; ++m)
      part(ray.by_motion[m]);
    part(ray.at_start);
    part(ray.beyond);
    part(ray.rub.bound);
    for (unsigned int m = 0; m < dim - 1; ++m)
    {
      part(ray.rub.slide[m]);
      part(ray.rub.known_slide[m]);
      for (unsigned int d = 0; d < dim; ++d)
        part(ray.rub.e[m][d]);
    }
    for (unsigned int s = state.flat_partner() ? 1 : 0; s < 2; ++s)
    {
      RaySide<dim> &side = ray.side[s];
      part(side.met);
      part(side.past_end);
      part(side.height);
      for (unsigned int d = 0; d < dim; ++d)
      {
        part(side.normal[d]);
        for (unsigned int k = 0; k < dim - 1; ++k)
          part(side.way[k][d]);
        for (unsigned int e = 0; e < dim; ++e)
          part(side.sliding_twice[d][e]);
      }
      for_place(side.place, part);
    }
  }

  FrameState<dim> &state;
};

template <int dim>
void meet_frames(const BodyShare &share,
                 const FrameScene<dim> &scene,
                 const std::vector<std::vector<double>> &force,
                 const std::vector<Eigen::VectorXd> &displacement,
                 const std::vector<Eigen::VectorXd> &way,
                 const double path,
                 const double within,
                 std::vector<FrameState<dim>> &frames)
{
  for (unsigned int f = 0; f < frames.size(); ++f)
    frames[f].prepare(scene, way, force[f], path, within);
  std::vector<std::size_t> first(1, 0); // of the numbers of every frame
  for (FrameState<dim> &frame : frames)
    first.push_back(first.back() + (share.alone() ? 0 : ToldFrame<dim>(frame).n_told()));
  std::vector<double> told(first.back());
  share.together(
      [&]()
      {
        parallel_for(frames.size(), 4,
                     [&](const std::size_t begin, const std::size_t end)
                     {
                       for (std::size_t f = begin; f < end; ++f)
                         if (is_here(share, frames[f]))
                         {
                           frames[f].look(scene, displacement, way,
                                          way_of_wall(scene, frames[f].layout().wall), force[f]);
                           if (!share.alone())
                             ToldFrame<dim>(frames[f]).tell(told.data() + first[f]);
                         }
                     });
      },
      [&](BodyShare::Message &message)
      {
        for (unsigned int f = 0; f < frames.size(); ++f)
          message.add(frames[f].body(1), told.data() + first[f], first[f + 1] - first[f]);
      });
  for (unsigned int f = 0; f < frames.size(); ++f)
    if (!is_here(share, frames[f]))
      ToldFrame<dim>(frames[f]).take(told.data() + first[f]);
}

template void meet_frames(const BodyShare &,
                          const FrameScene<2> &,
                          const std::vector<std::vector<double>> &,
                          const std::vector<Eigen::VectorXd> &,
                          const std::vector<Eigen::VectorXd> &,
                          double,
                          double,
                          std::vector<FrameState<2>> &);
template void meet_frames(const BodyShare &,
                          const FrameScene<3> &,
                          const std::vector<std::vector<double>> &,
                          const std::vector<Eigen::VectorXd> &,
                          const std::vector<Eigen::VectorXd> &,
                          double,
                          double,
                          std::vector<FrameState<3>> &);
} // namespace softgrain::mpm
