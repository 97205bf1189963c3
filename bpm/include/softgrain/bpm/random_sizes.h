// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_random_sizes_h
#define softgrain_bpm_random_sizes_h

#include <softgrain/bpm/settings.h>

#include <cstdint>
#include <random>
#include <vector>

namespace softgrain::bpm
{
/// Random numbers in [0, 1) that are the same with every compiler and library.
class Uniform
{
public:
  explicit Uniform(const std::uint64_t seed) : engine(seed) {}
  double operator()() { return (engine() >> 11) * 0x1.0p-53; }

private:
  std::mt19937_64 engine;
};

/// One diameter at random [m]: density ∝ d^-2 when uniform by area, constant when uniform by number.
double random_diameter(const PrimarySettings &settings, Uniform &random);

/// Radii [m] of `settings.number` primaries, or of as many as come nearest to @p area [m^2] in all.
std::vector<double> random_radii(const PrimarySettings &settings, double area, Uniform &random);
} // namespace softgrain::bpm

#endif
