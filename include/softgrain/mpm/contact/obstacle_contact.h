// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_obstacle_contact_h
#define softgrain_mpm_contact_obstacle_contact_h

#include <softgrain/mpm/contact/contact_geometry.h>
#include <softgrain/mpm/contact/moved_boundary.h>

#include <vector>

namespace softgrain::mpm
{
/**
 * @brief Rows between boundaries and obstacles, at some share of a step.
 *
 * What looks for contact on a boundary meets the pieces of an obstacle, from the side that it faces; the tips
 * of the obstacle, its ends and corners, meet the boundary, whose normal they then have. A seeker that is
 * more than a cell behind a piece is taken for one of the far side of a thin body.
 */
class ObstacleContact
{
public:
  explicit ObstacleContact(const ContactScene<2> &scene);

  /// The largest way of an obstacle in the step [m].
  double largest_way() const;

  /// Adds the rows of one body; @p rest is the gap up to which rows are needed besides what own motion asks
  /// for [m].
  void
  find(const Body<2> &body, const MovedBoundary &own, double rest, std::vector<ContactRow<2>> &rows) const;

private:
  struct Placed
  {
    const Obstacle *obstacle;
    Pose pose;              ///< at the share of the step
    double way = 0;         ///< largest [m]
    unsigned int wall;      ///< that rows name
    unsigned int first_key; ///< of its pieces, its tips follow
  };

  void find_at_pieces(const Placed &placed,
                      const Body<2> &body,
                      const MovedBoundary &own,
                      double margin,
                      std::vector<ContactRow<2>> &rows) const;
  void find_at_tips(const Placed &placed,
                    const Body<2> &body,
                    const MovedBoundary &own,
                    double margin,
                    std::vector<ContactRow<2>> &rows) const;
  ContactRow<2> start_row(const Placed &placed,
                          const Body<2> &body,
                          const MovedBoundary::Place &at,
                          const dealii::Tensor<1, 2> &normal,
                          double gap,
                          const dealii::Point<2> &drawn) const;

  const ContactScene<2> &scene;
  std::vector<Placed> list;
};
} // namespace softgrain::mpm

#endif
