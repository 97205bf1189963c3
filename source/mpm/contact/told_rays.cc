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

template <int dim>
template <class Part>
void FrameState<dim>::for_told(RayHere &ray, const Part &part) const
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
  for (unsigned int s = flat_partner() ? 1 : 0; s < 2; ++s)
  {
    RaySide<dim> &side = ray.side[s];
    part(side.met);
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

template <int dim>
std::size_t FrameState<dim>::n_told() const
{
  std::size_t of_ray = 0;
  RayHere any;
  for_told(any, Counter{of_ray});
  return (inertia() ? dim + beside.size() * of_ray : 0) +
         of_ray * std::count_if(rays.begin(), rays.end(), [](const RayHere &ray) { return ray.near; });
}

template <int dim>
void FrameState<dim>::tell(double *numbers)
{
  if (inertia())
  {
    *numbers++ = follows;
    for (unsigned int m = 0; m < dim - 1; ++m)
      *numbers++ = moved[m];
    for (RayHere &ray : beside)
      for_told(ray, Packer{numbers});
  }
  for (RayHere &ray : rays)
    if (ray.near)
      for_told(ray, Packer{numbers});
}

template <int dim>
void FrameState<dim>::take(const double *numbers)
{
  if (inertia())
  {
    follows = *numbers++ != 0.;
    for (unsigned int m = 0; m < dim - 1; ++m)
      moved[m] = *numbers++;
    for (RayHere &ray : beside)
      for_told(ray, Unpacker{numbers});
  }
  for (RayHere &ray : rays)
    if (ray.near)
      for_told(ray, Unpacker{numbers});
}

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
  for (const FrameState<dim> &frame : frames)
    first.push_back(first.back() + (share.alone() ? 0 : frame.n_told()));
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
                                          scene.way_of_wall(frames[f].layout().wall), force[f]);
                           if (!share.alone())
                             frames[f].tell(told.data() + first[f]);
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
      frames[f].take(told.data() + first[f]);
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
template std::size_t FrameState<2>::n_told() const;
template void FrameState<2>::tell(double *);
template void FrameState<2>::take(const double *);
} // namespace softgrain::mpm
