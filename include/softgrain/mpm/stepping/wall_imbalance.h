// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_wall_imbalance_h
#define softgrain_mpm_stepping_wall_imbalance_h

#include <softgrain/mpm/body/body.h>

#include <string>
#include <vector>

namespace softgrain::mpm
{
/// The wall that is least in balance with its load, and what it bears of it, in the plane and in space.
struct WallImbalance
{
  double share = 0.; ///< of the load that is not borne
  std::size_t wall = 0;
  bool slides = false;          ///< the load is along the tangent
  double force = 0., load = 0.; ///< on the wall from the bodies, and against it [N/m^(3-dim)]

  /// Becomes @p wall if that one bears less of its load. @param floor of loads, below which nothing is asked
  void compare(std::size_t wall, bool slides, double force, double load, double floor);

  /// What acts on it, for messages. @param name of the wall, @param unit of forces
  std::string in_words(const std::string &name, const std::string &unit) const;
};

/// Young's modulus of the softest body that is not driven [Pa].
template <int dim>
double softest(const std::vector<Body<dim>> &bodies);
} // namespace softgrain::mpm

#endif
