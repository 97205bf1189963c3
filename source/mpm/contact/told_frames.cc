// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/told_frames.h>

#include <cstring>
#include <type_traits>

namespace softgrain::mpm
{
namespace
{
using Frame = ContactFrame<2>;

constexpr std::size_t numbers_of_ray = (sizeof(Frame::RayPlace) + sizeof(double) - 1) / sizeof(double);
static_assert(std::is_trivially_destructible<Frame::RayPlace>::value, "a ray is more than its numbers");
} // namespace

void tell_frames(const std::vector<Frame> &frames, std::vector<double> &numbers)
{
  numbers.push_back(frames.size());
  for (const Frame &frame : frames)
  {
    for (const double n : {static_cast<double>(frame.rays.size()), static_cast<double>(frame.id),
                           static_cast<double>(frame.corner), static_cast<double>(frame.home[0]),
                           static_cast<double>(frame.home[1]), frame.spacing, frame.log_full_width[0],
                           frame.log_full_width[1]})
      numbers.push_back(n);
    for (unsigned int d = 0; d < 2; ++d)
      for (const double n : {frame.origin[d], frame.direction[d], frame.across[0][d]})
        numbers.push_back(n);
    for (const Frame::RayPlace &ray : frame.rays)
    {
      // As it is in memory: nothing that a ray comes to have can be forgotten here.
      numbers.resize(numbers.size() + numbers_of_ray);
      std::memcpy(&numbers[numbers.size() - numbers_of_ray], static_cast<const void *>(&ray), sizeof(ray));
    }
  }
}

std::vector<Frame> take_frames(const Frame &named, const double *&at)
{
  std::vector<Frame> frames(static_cast<std::size_t>(*at++), named);
  for (Frame &frame : frames)
  {
    frame.rays.resize(static_cast<std::size_t>(*at++));
    frame.id = static_cast<std::uint64_t>(*at++);
    frame.corner = static_cast<unsigned int>(*at++);
    for (int &n : frame.home)
      n = static_cast<int>(*at++);
    frame.spacing = *at++;
    for (double &width : frame.log_full_width)
      width = *at++;
    for (unsigned int d = 0; d < 2; ++d)
      for (double *const n : {&frame.origin[d], &frame.direction[d], &frame.across[0][d]})
        *n = *at++;
    for (Frame::RayPlace &ray : frame.rays)
    {
      std::memcpy(static_cast<void *>(&ray), at, sizeof(ray));
      at += numbers_of_ray;
    }
  }
  return frames;
}
} // namespace softgrain::mpm
