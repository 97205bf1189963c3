// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_analysis_assembly_h
#define softgrain_analysis_assembly_h

#include <softgrain/analysis/snapshot.h>
#include <softgrain/geometry/box.h>

#include <optional>
#include <vector>

namespace softgrain
{
/// All that two bodies, or a body and a wall, exert on each other: many rows of a snapshot, one contact of
/// bodies.
struct BodyContact
{
  unsigned int body_a = ContactState<2>::not_a_body; ///< the body that feels `force`
  unsigned int body_b = ContactState<2>::not_a_body; ///< larger than body_a, or not_a_body when it is a wall
  unsigned int wall = ContactState<2>::not_a_body;   ///< index into Snapshot::walls, or not_a_body
  dealii::Point<2> place;                            ///< mean of the places, weighted by normal force [m]
  dealii::Tensor<1, 2> normal; ///< unit, to body_a; mean of the normals, weighted by length
  dealii::Tensor<1, 2> force;  ///< on body_a, sum [N/m]
  double normal_force = 0;     ///< force * normal, compression positive [N/m]
  double length = 0;           ///< sum, but not more than from the first to the last row [m]

  bool with_wall() const { return body_b == ContactState<2>::not_a_body; }
};

/// The box, and how fast it changes.
struct MovingBox : Box<2>
{
  double width_rate = 0;  ///< [m/s]
  double height_rate = 0; ///< [m/s]
  double slide_rate = 0;  ///< of the top along x, against the bottom [m/s]
};

/// What a measure may know beside the snapshot.
struct MeasureContext
{
  const Snapshot<2> *first = nullptr;    ///< of the run; null: not known
  const Snapshot<2> *previous = nullptr; ///< the one before; null: there is none
  std::optional<double> friction;        ///< between bodies
};

/**
 * @brief A snapshot as measures see it: contacts merged by pair of bodies, and the box.
 *
 * Contacts inside a body, as between the primaries of an aggregate, are left out.
 */
class Assembly
{
public:
  /// @param snapshot kept by reference, as are those of @p context
  explicit Assembly(const Snapshot<2> &snapshot, const MeasureContext &context = MeasureContext());

  /// Diameter of the disk that has the area of body @p b at rest [m].
  double rest_diameter(unsigned int b) const;

  const Snapshot<2> &snapshot;
  const MeasureContext context;
  /// Contacts in the order of body_a, then body_b, then walls.
  std::vector<BodyContact> contacts;
  /// The box; there is none unless all four walls are there.
  std::optional<MovingBox> box;
};
} // namespace softgrain

#endif
