// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_contact_geometry_h
#define softgrain_mpm_contact_contact_geometry_h

#include <softgrain/driving/cell_motion.h>
#include <softgrain/driving/obstacle.h>
#include <softgrain/mpm/body/body.h>
#include <softgrain/mpm/body/body_share.h>
#include <softgrain/mpm/contact/contact_rows.h>
#include <softgrain/mpm/contact/subgrid_compliance.h>
#include <softgrain/scene/contact_pairs.h>

#include <vector>

namespace softgrain::mpm
{
struct MovedOutlines;

/// What a search for contact rows looks at.
template <int dim>
struct ContactScene
{
  const std::vector<Body<dim>> &bodies;
  const std::vector<dealii::Tensor<1, dim>> &drive; ///< of driven bodies in the step, one per body [m/s]
  const std::vector<WallMotion<dim>> &walls;
  const ContactPairs &pairs; ///< what they do to each other
  double dt;                 ///< of the step to come [s]
  double cell_size;          ///< [m]
  /// Displacement of the nodes of every body over the step, as far as it is known [m]; null: that of the
  /// velocities at its start.
  const std::vector<Eigen::VectorXd> *increment = nullptr;
  /// Where in the step places and normals are taken: 0 its start, 1 its end.
  double share = 0.5;
  bool free_places = false; ///< places of round bodies that look for contact need not turn with them
  /// Whether rows count that such places slide along outlines, see PlaceSlide.
  bool places_slide = false;
  SubgridCompliance subgrid; ///< what the grid misses of dents
  double adhesion_reach = 0; ///< gap up to which rows may pull [m]
  /// Rows are wanted where bodies are nearer than this many times the way by which they approach each other
  /// over the step. A search that is followed by others for what comes out needs less.
  double foresight = 2.;
  bool gaps_only = false;   ///< of rows `key` and `gap_where_found` are all that is asked for
  bool places_only = false; ///< of outlines no more is asked than where their markers are and how they move
  const std::vector<Obstacle> *obstacles = nullptr; ///< with their way in the step; null: none
  const CellMotion *cell = nullptr;                 ///< null: nothing repeats
  const BodyShare *looking = nullptr;               ///< bodies of this rank look for contact; null: all do
  /// Outlines that were moved before, as share_outlines() makes them; find() takes them. Null: none were.
  MovedOutlines *moved = nullptr;
};

/// Gives a row what the two that meet there do to each other.
template <int dim>
void take_pair(const ContactScene<dim> &scene, ContactRow<dim> &row)
{
  const bool wall = row.wall != ContactRow<dim>::none;
  row.friction =
      wall ? scene.pairs.friction_at_wall(row.body, row.wall) : scene.pairs.friction(row.body, row.partner);
  row.adhesion =
      wall ? scene.pairs.adhesion_at_wall(row.body, row.wall) : scene.pairs.adhesion(row.body, row.partner);
}

/**
 * @brief Finds the rows at which bodies and walls may touch during a step.
 */
template <int dim>
class ContactGeometry
{
public:
  virtual ~ContactGeometry() = default;

  /// Rows with the gaps that they have at the start of the step, in an order that does not depend on the
  /// number of threads.
  virtual void find(const ContactScene<dim> &scene, std::vector<ContactRow<dim>> &rows) const = 0;

  /// Whether find() heeds ContactScene::looking, and gives rows in the order of the bodies that look. Else
  /// every rank finds those of all bodies.
  virtual bool looks_by_body() const { return false; }
};
} // namespace softgrain::mpm

#endif
