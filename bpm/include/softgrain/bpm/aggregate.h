// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_aggregate_h
#define softgrain_bpm_aggregate_h

#include <softgrain/bpm/attraction.h>
#include <softgrain/bpm/settings.h>
#include <softgrain/scene/scene.h>

#include <array>
#include <memory>
#include <vector>

namespace softgrain::bpm
{
/// Primaries at rest that make one body, relative to the centre of the body's description.
template <int dim>
struct Aggregate
{
  std::vector<std::array<double, dim>> position; ///< [m]
  std::vector<double> radius;                    ///< [m]

  std::size_t size() const { return radius.size(); }
};

/// Mass of a primary over its density: area of a disk [m^2], volume of a ball [m^3].
template <int dim>
double size_of_primary(double radius);

/// Time in which attraction moves a primary at rest by its own diameter, sqrt(m a0 / F0) [s].
template <int dim>
double attraction_time(double diameter, double density, double contact_force);

/// Sizes that do not go together would need more memory than there is, or numbers that are none.
/// @throw InputError when a body named @p body would be cut from too many primaries
void check_number(const std::string &body, double n_primaries);

/**
 * @brief Fills the shape of @p body with primaries at rest.
 *
 * Cut out of a random packing, dense in the plane (pack_disks()) and less so in space (pack_balls()), where
 * attraction makes it dense: the primaries that lie deepest inside, a given number or as many as fill the
 * shape; then attraction and inelastic contacts alone until at rest, which draws the
 * aggregate together a little. Without a given number those that then reach beyond the outline are taken
 * away. The same input gives the same aggregate on every machine of one arithmetic, whatever the number of
 * threads.
 *
 * @throw ComputationError when it does not come to rest. @throw InputError when not even one primary fits.
 */
template <int dim>
Aggregate<dim> make_aggregate(const BodyDescription<dim> &body,
                              double density,
                              const std::shared_ptr<const Attraction> &attraction,
                              const Settings &settings,
                              std::uint64_t seed);
} // namespace softgrain::bpm

#endif
