// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/told_frames.h>

#include <cstring>
#include <type_traits>

namespace softgrain::mpm
{
namespace
{
template <int dim>
constexpr std::size_t numbers_of_ray = (sizeof(typename ContactFrame<dim>::RayPlace) + sizeof(double) - 1) /
                                       sizeof(double);
static_assert(std::is_trivially_destructible<ContactFrame<3>::RayPlace>::value,
              "a ray is more than its numbers");
} // namespace

template <int dim>
void tell_frames(const std::vector<ContactFrame<dim>> &frames, std::vector<double> &numbers)
{
  numbers.push_back(frames.size());
  for (const ContactFrame<dim> &frame : frames)
  {
    for (const double n :
         {static_cast<double>(frame.rays.size()), static_cast<double>(frame.id),
          static_cast<double>(frame.corner), frame.spacing, frame.log_full_width[0], frame.log_full_width[1]})
      numbers.push_back(n);
    for (unsigned int d = 0; d < dim; ++d)
    {
      for (const double n : {static_cast<double>(frame.home[d]), frame.origin[d], frame.direction[d]})
        numbers.push_back(n);
      for (const auto &across : frame.across)
        numbers.push_back(across[d]);
    }
    for (const typename ContactFrame<dim>::RayPlace &ray : frame.rays)
    {
      // As it is in memory: nothing that a ray comes to have can be forgotten here.
      numbers.resize(numbers.size() + numbers_of_ray<dim>);
      std::memcpy(&numbers[numbers.size() - numbers_of_ray<dim>], static_cast<const void *>(&ray),
                  sizeof(ray));
    }
  }
}

template <int dim>
std::vector<ContactFrame<dim>> take_frames(const ContactFrame<dim> &named, const double *&at)
{
  std::vector<ContactFrame<dim>> frames(static_cast<std::size_t>(*at++), named);
  for (ContactFrame<dim> &frame : frames)
  {
    frame.rays.resize(static_cast<std::size_t>(*at++));
    frame.id = static_cast<std::uint64_t>(*at++);
    frame.corner = static_cast<unsigned int>(*at++);
    frame.spacing = *at++;
    for (double &width : frame.log_full_width)
      width = *at++;
    for (unsigned int d = 0; d < dim; ++d)
    {
      frame.home[d] = static_cast<int>(*at++);
      frame.origin[d] = *at++;
      frame.direction[d] = *at++;
      for (auto &across : frame.across)
        across[d] = *at++;
    }
    for (typename ContactFrame<dim>::RayPlace &ray : frame.rays)
    {
      std::memcpy(static_cast<void *>(&ray), at, sizeof(ray));
      at += numbers_of_ray<dim>;
    }
  }
  return frames;
}

template void tell_frames(const std::vector<ContactFrame<2>> &, std::vector<double> &);
template std::vector<ContactFrame<2>> take_frames(const ContactFrame<2> &, const double *&);
template void tell_frames(const std::vector<ContactFrame<3>> &, std::vector<double> &);
template std::vector<ContactFrame<3>> take_frames(const ContactFrame<3> &, const double *&);
} // namespace softgrain::mpm
