// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_body_body_builder_h
#define softgrain_mpm_body_body_builder_h

#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/body/point_store.h>
#include <softgrain/mpm/body/step_state.h>
#include <softgrain/mpm/field/lattice.h>
#include <softgrain/mpm/field/shape_function.h>
#include <softgrain/mpm/model/settings.h>
#include <softgrain/scene/scene.h>

#include <memory>
#include <vector>

namespace softgrain::mpm
{
/// What all bodies of a scene share when they are built.
struct BuildContext
{
  const Lattice<2> &lattice;
  const ShapeFunction &shape;
  const Settings &settings;
  PointStore<2> &points; ///< of all bodies whose points lie here
};

/**
 * @brief A body at rest in its place, but for its points: fill_body() makes them.
 * @param levels sizes of its cells; none: as the lattice has them
 * @throw InputError when it reaches out of the mesh
 */
Body<2> make_body(const BodyDescription<2> &description,
                  unsigned int index,
                  std::shared_ptr<const constitutive::Law<2>> law,
                  double density,
                  const BuildContext &context,
                  std::shared_ptr<const CellLevels<2>> levels = nullptr);

/// Makes the points of a body. Their order is to be found, then follows start_body(). @throw InputError when
/// it holds no point
void fill_body(Body<2> &body, const BodyDescription<2> &description, const BuildContext &context);

/// Lays the first grid and gives nodes and points their initial velocity. @throw InputError
void start_body(Body<2> &body, const BodyDescription<2> &description, const BuildContext &context);

/// The slab of material points, three cells thick, that stands for a wall; it is driven and has no law of its
/// own use.
/// @throw InputError when the wall is not parallel to an axis or the slab leaves the mesh
BodyDescription<2> wall_slab(const WallDescription<2> &wall, const BuildContext &context);

/**
 * @brief Lays the grid under the points of a body, sorted before: numbering, shape values, lumped mass and
 * what the points bring to the nodes (@cite nguyen2016, eqs. (3.10) and (3.13)).
 */
void lay_grid(Body<2> &body, const BuildContext &context);

/// Where the grid has taken the points of a body [m]. @throw ComputationError when one has left the mesh
std::vector<dealii::Point<2>> places_reached(const Body<2> &body, const Lattice<2> &lattice);

/**
 * @brief Gives what the nodes have reached to the points of a body that lie here, before they are sorted and
 * the grid is laid anew: places, deformation, velocities; the volumes of small-strain laws are those of @p s.
 */
void leave_grid(Body<2> &body,
                const StepState<2> &s,
                const std::vector<dealii::Point<2>> &places,
                const BuildContext &context);

/// @throw ComputationError when a marker has left the mesh
void check_markers(const Body<2> &body, const Lattice<2> &lattice);

/// Places of the boundary markers for the present displacement of the nodes.
template <int dim>
void move_boundary(Body<dim> &body);

/// Largest over smallest stretch of the grid at any point since it was laid.
double grid_distortion(const StepState<2> &s);
} // namespace softgrain::mpm

#endif
