// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_primaries_h
#define softgrain_bpm_primaries_h

#include <softgrain/contact/disk_system.h>

#include <array>
#include <cstdint>
#include <vector>

namespace softgrain::bpm
{
/// Rigid disks, in space balls, that bodies are made of, one entry of every vector per disk; those of a body
/// follow each other.
template <int dim>
struct RoundPrimaries
{
  std::vector<std::array<double, dim>> position; ///< [m]
  std::vector<std::array<double, dim>> velocity; ///< [m/s]
  std::vector<double> radius;                    ///< [m]
  std::vector<double> mass;                      ///< [kg/m], in space [kg]
  std::vector<std::uint32_t> body;               ///< index of the body (aggregate)
  std::vector<contact::Turning<dim>>
      angular_velocity; ///< [rad/s]; empty unless friction or rolling asks for it

  std::vector<double> strength; ///< of the attraction, over that of the law: a pair has the mean; empty: 1

  std::vector<std::array<double, dim>> start; ///< places at the start; empty unless a load asks for them [m]

  std::vector<std::uint32_t> number; ///< among all there are; empty: all are here

  std::uint32_t number_of(const std::size_t i) const { return number.empty() ? i : number[i]; }
  std::size_t size() const { return position.size(); }
  bool rotate() const { return !angular_velocity.empty(); }

  /// [m]
  double mean_diameter() const
  {
    double sum = 0.;
    for (const double r : radius)
      sum += 2. * r / size();
    return sum;
  }
};

using Primaries = RoundPrimaries<2>;
using Balls = RoundPrimaries<3>;

/// What a step changes of primaries, to go back to.
template <int dim>
struct RoundMotion
{
  std::vector<std::array<double, dim>> position;       ///< [m]
  std::vector<std::array<double, dim>> velocity;       ///< [m/s]
  std::vector<contact::Turning<dim>> angular_velocity; ///< [rad/s]
};

using Motion = RoundMotion<2>;
} // namespace softgrain::bpm

#endif
