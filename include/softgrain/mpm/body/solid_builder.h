// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_body_solid_builder_h
#define softgrain_mpm_body_solid_builder_h

#include <softgrain/geometry/solid.h>
#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/body/point_generator.h>
#include <softgrain/mpm/body/point_store.h>
#include <softgrain/mpm/field/lattice.h>
#include <softgrain/mpm/field/shape_function.h>
#include <softgrain/mpm/model/settings.h>

#include <memory>

namespace softgrain::mpm
{
/**
 * @brief Fills a body in space with points: @p per_direction^3 equal parts of every cell, each cut by the
 * surface.
 *
 * A part that the surface cuts is integrated along columns, each of which ends where it leaves the body; the
 * point sits at the centroid and carries the volume. Volumes are scaled to that of the shape, by what the
 * columns miss of it.
 */
GeneratedPoints<3>
generate_points(const Shape<3> &shape, const Lattice<3> &lattice, unsigned int per_direction);

/**
 * @brief A body in space at rest in its place, with points in @p store and its first grid; its displacement
 * is zero.
 * @param markers places where the field must exist too, such as the vertices of its surface [m]
 * @param store   covers the mesh, and has no other points
 * @throw InputError when it reaches out of the mesh
 */
Body<3> make_solid(const std::string &name,
                   const Shape<3> &shape,
                   std::shared_ptr<const constitutive::Law<3>> law,
                   double density,
                   const Settings &settings,
                   const ShapeFunction &function,
                   const Lattice<3> &lattice,
                   const std::vector<dealii::Point<3>> &markers,
                   PointStore<3> &store);
} // namespace softgrain::mpm

#endif
