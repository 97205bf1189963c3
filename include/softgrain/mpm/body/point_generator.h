// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_body_point_generator_h
#define softgrain_mpm_body_point_generator_h

#include <softgrain/mpm/field/cell_levels.h>
#include <softgrain/mpm/field/lattice.h>
#include <softgrain/scene/scene.h>

#include <deal.II/base/point.h>

#include <vector>

namespace softgrain::mpm
{
/// Material points of one body at rest.
template <int dim>
struct GeneratedPoints
{
  std::vector<dealii::Point<dim>> position; ///< [m]
  std::vector<double> volume;               ///< [m^dim]
};

/**
 * @brief Fills a body with points: @p per_direction^dim equal parts of every cell, each cut by the body's
 * boundary.
 *
 * A point sits at the centroid of its part and carries exactly its area, so that mass, centre of mass and the
 * integrals of linear functions are those of the body however the mesh cuts it.
 *
 * @param levels sizes of the cells of this body; none: as the lattice has them
 */
GeneratedPoints<2> generate_points(const BodyDescription<2> &body,
                                   const Lattice<2> &lattice,
                                   unsigned int per_direction,
                                   const CellLevels<2> *levels = nullptr);
} // namespace softgrain::mpm

#endif
