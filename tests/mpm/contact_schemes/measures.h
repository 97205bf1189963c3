// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_mpm_contact_schemes_measures_h
#define softgrain_tests_mpm_contact_schemes_measures_h

#include <algorithm>
#include <cmath>
#include <vector>

namespace softgrain::schemes
{
/// What an exact solution says of an impact with constant pressure.
struct Impact
{
  double start, end; ///< of contact
  double pressure;
  double energy;    ///< before
  double unit_move; ///< of displacements: the largest that the impact makes
};

/// Figures of an impact, gathered step by step.
class ImpactMeasures
{
public:
  explicit ImpactMeasures(const Impact &exact) : exact(exact) {}

  /// @param from,to the step @param energy,gap at its end @param error of displacements at its end, r.m.s.
  void look(const double from,
            const double to,
            const double impulse,
            const double energy,
            const double gap,
            const double error)
  {
    const double duration = exact.end - exact.start, pressure = impulse / (to - from) / exact.pressure;
    if (from > exact.start && to < exact.end)
    {
      squares += (pressure - 1.) * (pressure - 1.) * (to - from);
      time += to - from;
    }
    contact_took -= impulse * (gap - last_gap) / (to - from) / exact.energy;
    last_gap = gap;
    if (pressure > 0.01)
      contact_end = (to - exact.end) / duration;
    gained = std::max(gained, energy / exact.energy - 1.);
    kept = energy / exact.energy - 1.;
    penetration = std::max(penetration, -gap / exact.unit_move);
    displacement = std::max(displacement, error / exact.unit_move);
  }

  double noise() const { return time > 0. ? std::sqrt(squares / time) : 0.; }

  double gained = 0.; ///< energy, at most, over that before
  double kept = 0.;   ///< the same at the end
  /// Energy that contact took, over that before, where the impulse works on the mean velocity of the step.
  double contact_took = 0.;
  double contact_end = 0.;  ///< too late by this share of the exact duration
  double penetration = 0.;  ///< over the largest displacement of the exact impact
  double displacement = 0.; ///< error, largest over time of the r.m.s., in the same unit
  double restitution = 0.;

private:
  Impact exact;
  double squares = 0., time = 0.;
  double last_gap = 0.; ///< impulses are zero at first, whatever it was
};

/// Of several runs that begin at other fractions of a step: means of energies and restitution, else the
/// worst.
struct Summary
{
  double gained = 0., kept = 0., least = 1e300, contact_took = 0., noise = 0., contact_end = 0.,
         penetration = 0., displacement = 0., restitution = 0., least_restitution = 1e300;
  unsigned int n = 0;

  void add(const ImpactMeasures &one)
  {
    gained = std::max(gained, one.gained);
    least = std::min(least, one.kept);
    noise = std::max(noise, one.noise());
    if (std::abs(one.contact_end) > std::abs(contact_end))
      contact_end = one.contact_end;
    penetration = std::max(penetration, one.penetration);
    displacement = std::max(displacement, one.displacement);
    least_restitution = std::min(least_restitution, one.restitution);
    kept = (n * kept + one.kept) / (n + 1);
    contact_took = (n * contact_took + one.contact_took) / (n + 1);
    restitution = (n * restitution + one.restitution) / (n + 1);
    ++n;
  }
};
} // namespace softgrain::schemes

#endif
