// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_random_h
#define softgrain_base_random_h

#include <cstdint>
#include <random>

namespace softgrain
{
/// Random numbers in [0, 1), the same with every compiler and library (those of the standard's distributions
/// are not).
class Uniform
{
public:
  explicit Uniform(const std::uint64_t seed) : engine(seed) {}
  double operator()() { return (engine() >> 11) * 0x1.0p-53; }

private:
  std::mt19937_64 engine;
};
} // namespace softgrain

#endif
