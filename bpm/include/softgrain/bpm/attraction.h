// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_attraction_h
#define softgrain_bpm_attraction_h

#include <softgrain/base/registry.h>

#include <cstddef>
#include <string>
#include <vector>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain::bpm
{
/**
 * @brief How the primaries of one aggregate attract each other: a central force of the distance alone.
 *
 * A law is one source file that registers itself (see power_law.cc). Pairs come in batches, so that the
 * virtual call costs nothing and the loop over the pairs can be vectorised.
 */
class Attraction
{
public:
  virtual ~Attraction() = default;

  /// Title of the subsection with the parameters of the law, inside `Materials/NAME`.
  virtual std::string title() const = 0;
  virtual void declare_parameters(dealii::ParameterHandler &prm) const = 0;
  /// The handler stands in the law's subsection. @throw InputError when a value is not allowed.
  virtual void parse_parameters(dealii::ParameterHandler &prm) = 0;

  /// Primaries attract each other up to this distance of centres over the sum of their radii (at least 1).
  virtual double range() const = 0;

  /// Force at contact [N/m in 2D]: the scale of forces and of the time step.
  virtual double contact_force() const = 0;

  /// F0 of the characteristic stress p_I = F0 / a0 (@cite nguyen2016, eq. (3.32)) [N/m in 2D].
  virtual double characteristic_force() const { return contact_force(); }

  /**
   * @brief Attraction of @p n pairs.
   *
   * @param n number of pairs
   * @param distance of their centres [m], below range() times @p sum; may be below @p sum when they overlap
   * @param sum of their radii a0 [m]
   * @param force attraction, positive [N/m in 2D], out
   * @param energy stored, zero at the end of the range [J/m in 2D], out; may be null
   */
  virtual void
  evaluate(std::size_t n, const double *distance, const double *sum, double *force, double *energy) const = 0;
};

/// Attraction of one pair, 0 out of range. @param distance of their centres [m] @param sum of their radii [m]
/// @return [N/m in 2D]
inline double attraction_at(const Attraction &law, const double distance, const double sum)
{
  double force = 0.;
  if (distance < law.range() * sum)
    law.evaluate(1, &distance, &sum, &force, nullptr);
  return force;
}
} // namespace softgrain::bpm

namespace softgrain
{
template <>
Registry<bpm::Attraction> &Registry<bpm::Attraction>::instance();
}

#endif
