// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_packing_shrinking_box_h
#define softgrain_packing_shrinking_box_h

#include <softgrain/base/random.h>
#include <softgrain/contact/disk_system.h>
#include <softgrain/contact/neighbour_list.h>

#include <array>
#include <vector>

namespace softgrain
{
/**
 * @brief A box about the origin that shrinks, with rigid disks in it that the contact kernel keeps apart.
 *
 * A direction has walls or is periodic: a disk that leaves on one side enters on the other. Velocities are
 * displacements of one step. The mass of a disk is its area. Friction, if any, resists motion relative to
 * that of the box.
 */
class ShrinkingBox
{
public:
  using Place = std::array<double, 2>;

  /// Which box, and what is between the disks.
  struct Form
  {
    Place half{};                   ///< of the edges [m]
    std::array<bool, 2> periodic{}; ///< directions without walls
    double friction = 0.;           ///< between disks, and with walls
  };

  /// Throws the disks in at random without overlap, the largest first. @throw InputError when they do not
  /// fit.
  ShrinkingBox(const std::vector<double> &radii, const Form &form, Uniform &random);

  /// Share that the box may lose in a step, at most.
  static constexpr double largest_shrinkage = 0.01;

  /// Shrinks by @p factor, just below 1, and keeps the disks apart. @return the deepest overlap left [m].
  double step(double factor);

  /// Grows by @p factor, just above 1; centres move with it.
  void loosen(double factor);

  const std::vector<Place> &disks() const { return places; }
  /// Half of the first edge [m].
  double scale() const { return form.half[0]; }

  /// Places and box as they were before.
  void restore(const std::vector<Place> &old_places, double old_scale);

private:
  static constexpr unsigned int n_walls = 4;

  void set_bodies(double factor);
  void set_contacts(double factor);
  void add(std::uint32_t a, std::uint32_t b, const Place &normal, double gap, double closing);
  void move(double factor);
  double deepest_overlap() const;

  static Place normal_of(unsigned int wall);
  bool is_wall(const unsigned int wall) const { return !form.periodic[wall / 2]; }
  double wall_gap(unsigned int wall, std::size_t disk) const;
  bool co_moving() const { return form.periodic[0] || form.periodic[1]; }

  /// Vector from disk b to disk a [m]; @p nearest over the periodic sides, else straight.
  Place branch(std::uint32_t a, std::uint32_t b, bool nearest) const;
  /// Calls work(a, b, branch) once for every pair of disks nearer than @p reach of each other across a
  /// periodic side.
  template <class Work>
  void for_pairs_across(double reach, const Work &work) const;

  std::vector<double> radius;
  Form form;
  double mean, largest; ///< radius
  std::vector<Place> places;
  contact::NeighbourList list;
  contact::DiskBodies bodies;
  contact::DiskContacts contacts;
};
} // namespace softgrain

#endif
