// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_analysis_assembly_h
#define softgrain_analysis_assembly_h

#include <softgrain/analysis/snapshot.h>
#include <softgrain/geometry/box.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace softgrain
{
/// All that two bodies, or a body and a wall, exert on each other: many rows of a snapshot, one contact of
/// bodies.
template <int dim>
struct BodyContactIn
{
  unsigned int body_a = ContactState<dim>::not_a_body; ///< the body that feels `force`
  unsigned int body_b =
      ContactState<dim>::not_a_body;                 ///< larger than body_a, or not_a_body when it is a wall
  unsigned int wall = ContactState<dim>::not_a_body; ///< index into Snapshot::walls, or not_a_body
  dealii::Point<dim> place;                          ///< mean of the places, weighted by normal force [m]
  dealii::Tensor<1, dim> normal; ///< unit, to body_a; mean of the normals, weighted by length
  dealii::Tensor<1, dim> force;  ///< on body_a, sum [N/m in 2D]
  double normal_force = 0;       ///< force * normal, compression positive [N/m in 2D]
  double length = 0;             ///< sum, but not more than from the first to the last row; 0 in space [m]

  bool with_wall() const { return body_b == ContactState<dim>::not_a_body; }
};
using BodyContact = BodyContactIn<2>;

/// The box, and how fast it changes.
template <int dim>
struct MovingBox : Box<dim>
{
  std::array<double, dim> rate{}; ///< of the edges [m/s]
  double slide_rate = 0;          ///< of the top along x, against the bottom [m/s]

  /// The fastest rate of strain [1/s].
  double strain_rate() const
  {
    double fastest = std::abs(slide_rate) / this->height();
    for (unsigned int d = 0; d < dim; ++d)
      fastest = std::max(fastest, std::abs(rate[d]) / this->edge[d]);
    return fastest;
  }
};

/// What a measure may know beside the snapshot.
template <int dim>
struct MeasureContextIn
{
  const Snapshot<dim> *first = nullptr;    ///< of the run; null: not known
  const Snapshot<dim> *previous = nullptr; ///< the one before; null: there is none
  std::optional<double> friction;          ///< between bodies
};
using MeasureContext = MeasureContextIn<2>;

/**
 * @brief A snapshot as measures see it: contacts merged by pair of bodies, and the box.
 *
 * Contacts inside a body, as between the primaries of an aggregate, are left out.
 */
template <int dim>
class AssemblyIn
{
public:
  /// @param snapshot kept by reference, as are those of @p context
  explicit AssemblyIn(const Snapshot<dim> &snapshot,
                      const MeasureContextIn<dim> &context = MeasureContextIn<dim>());

  /// Diameter of the ball, in the plane the disk, that has the volume or area of body @p b at rest [m].
  double rest_diameter(unsigned int b) const;

  const Snapshot<dim> &snapshot;
  const MeasureContextIn<dim> context;
  /// Contacts in the order of body_a, then body_b, then walls.
  std::vector<BodyContactIn<dim>> contacts;
  /// The box; there is none unless all its walls are there.
  std::optional<MovingBox<dim>> box;
};
using Assembly = AssemblyIn<2>;

extern template class AssemblyIn<2>;
extern template class AssemblyIn<3>;
} // namespace softgrain

#endif
