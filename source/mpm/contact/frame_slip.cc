// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction that slips: its direction, which in space is an unknown.
#include <softgrain/mpm/contact/frame_system.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
constexpr double most_off_direction = 0.5; ///< friction across its direction over friction
} // namespace

/// Friction across the direction in which a ray slips, where it is so much that the direction must change;
/// else 0.
template <int dim>
double FrameSystem<dim>::off_direction(const unsigned int i) const
{
  if (dim == 2)
    return 0.;
  return std::abs(z[i + 1]) > most_off_direction * std::abs(z[i]) ? std::abs(z[i + 1]) : 0.;
}

/// What friction has become, at its bound where it slips; z goes back to the directions of V.
template <int dim>
void FrameSystem<dim>::note_friction(const unsigned int i)
{
  Across friction = found_friction(i);
  for (unsigned int m = 0; m < dim - 1; ++m)
    z[i + m] = friction * columns[i + m].axis_of_v;
  // Across its old direction it has grown beyond its bound.
  if (dim == 3 && friction.norm() > 0. && !columns[i].keeps)
    friction *= std::min(1., most_friction(i) / friction.norm());
  found_rubbing[columns[i].frame][columns[i].ray_number] = friction;
}

template <int dim>
typename FrameSystem<dim>::Across FrameSystem<dim>::found_friction(const unsigned int first) const
{
  Across friction;
  for (unsigned int m = 0; m < dim - 1; ++m)
    friction += z[first + m] * columns[first + m].axis;
  return friction;
}

template <int dim>
void FrameSystem<dim>::turn_slides(const unsigned int first, const double c, const double s)
{
  const auto turn = [&](double &one, double &other)
  {
    const double before = one;
    one = c * before + s * other;
    other = c * other - s * before;
  };
  turn(z[first], z[first + 1]);
  turn(right[first], right[first + 1]);
  turn(from.z[first], from.z[first + 1]);
  turn(from.here[first], from.here[first + 1]);
  turn(nearest[first], nearest[first + 1]);
  const Across axis = columns[first].axis;
  columns[first].axis = c * axis + s * columns[first + 1].axis;
  columns[first + 1].axis = c * columns[first + 1].axis - s * axis;
  for (const unsigned int b : bodies_of[columns[first].frame])
    if (b != FrameState<dim>::none)
    {
      const int i = place_in(of_body[b], first);
      for (int j = 0; j < W[b].rows(); ++j)
        turn(W[b](i, j), W[b](i + 1, j));
      for (int j = 0; j < W[b].rows(); ++j)
        turn(W[b](j, i), W[b](j, i + 1));
    }
}

template double FrameSystem<2>::off_direction(unsigned int) const;
template double FrameSystem<3>::off_direction(unsigned int) const;
template void FrameSystem<3>::turn_slides(unsigned int, double, double);
template void FrameSystem<2>::note_friction(unsigned int);
template void FrameSystem<3>::note_friction(unsigned int);
template FrameSystem<2>::Across FrameSystem<2>::found_friction(unsigned int) const;
template FrameSystem<3>::Across FrameSystem<3>::found_friction(unsigned int) const;
} // namespace softgrain::mpm
