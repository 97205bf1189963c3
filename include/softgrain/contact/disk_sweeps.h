// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_disk_sweeps_h
#define softgrain_contact_disk_sweeps_h

#include <softgrain/contact/ball_rows.h>
#include <softgrain/contact/disk_rows.h>
#include <softgrain/contact/disk_share.h>
#include <softgrain/contact/disk_system.h>
#include <softgrain/contact/thread_team.h>

#include <array>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace softgrain::contact
{
/**
 * @brief Contacts packed for sweeping, and the loops over them, on all threads and with the same bits for any
 * number of them.
 *
 * A contact would have to wait for a velocity that the contact before it has just written. So the contacts of
 * a tile are interleaved: four from distant parts of the tile follow each other, and the processor works on
 * them at the same time. Bodies are renumbered in the order in which the contacts meet them.
 *
 * Several may share the contacts, see DiskShare; each packs and sweeps its own. Where all know all
 * contacts, store_impulses() and store_velocities() make all known to all. They call the same in the
 * same order.
 * @tparam n impulses of a contact: 1 normal; in the plane 2 with friction, 3 with rolling resistance; in
 * space 4 with friction, which is a vector
 * @tparam in_cell contacts know their branch, and a cell that deforms parts or closes them. Where that is
 * free to deform, it has a part in all contacts, which are then swept one after the other. In the plane
 * @tparam dim 2: disks, 3: balls
 */
template <unsigned int n, bool in_cell = false, int dim = 2>
class DiskSweeps
{
public:
  using Bodies = RoundBodies<dim>;
  using Contacts = RoundContacts<dim>;

  /// What measure() finds.
  struct Measure
  {
    double natural_map = 0.; ///< largest over the contacts [m/s]; not a number when anything is not
    double approach = 0.;    ///< largest speed of approach that an impulse could still change [m/s]
  };

  /// Packs; set_free_velocities() comes next. All arguments have to stay. By @p exchange several share the
  /// contacts, unless the cell is free to deform; null: this process sweeps all. With @p exchanges each of
  /// them has its own contacts and bodies alone.
  DiskSweeps(const Bodies &bodies,
             const Contacts &contacts,
             ThreadTeam &team,
             const Exchange *exchange = nullptr,
             const DiskExchanges *exchanges = nullptr);

  /// Whether only a part of the contacts is swept here.
  bool shared() const { return share.has_value(); }

  /// Velocities of the bodies as they are without impulses.
  void set_free_velocities();

  /// Adds what the impulses make of the velocities.
  void apply_impulses();

  /// No impulses.
  void clear_impulses();

  /// Every contact once, with the change of its impulse multiplied by @p relaxation.
  void sweep(double relaxation);

  /**
   * Every contact once, from the impulses and velocities extrapolated by @p momentum times their last change.
   *
   * @return Σ W (y - P)·(P - P_old), y extrapolated, P after, P_old before: above 0 the momentum points
   * uphill. Where contacts are shared only where n is 1, else 0: nobody asks for it.
   */
  double sweep_with_momentum(double momentum);

  /// Keeps the impulses for restore_impulses(); without it that does nothing.
  void save_impulses();
  void restore_impulses();

  Measure measure();

  /// Sum of the normal impulses on every wall, by first appearance in the contacts [N s/m]; after them what a
  /// free cell feels, over its mean branch.
  void wall_impulses(std::vector<double> &sums) const;

  /// Impulses to @p contacts, in the order that they came in.
  void store_impulses(Contacts &contacts);
  /// Velocities to @p bodies; those without contact stay as they are.
  void store_velocities(Bodies &bodies);

private:
  using Row = std::conditional_t<in_cell, DiskRowInCell<n>, DiskRow<n, dim>>;
  using State = DiskState<(n > 1), dim>;
  template <bool wall>
  using Contact = DiskContact<n, wall, dim>;
  /// Components of a velocity, and of a rotation behind it.
  static constexpr unsigned int n_velocities = n == 1 ? dim : dim == 2 ? 3 : 6;

  using Range = ContactRange;

  std::size_t n_bodies() const { return original_of.size(); }
  void number_bodies(const DiskExchanges *exchanges);
  void make_ranges();
  void pack(Range range, bool wall);
  void extrapolate(double momentum);
  /// What the cell adds to velocity and compliance of a contact; nothing but in a cell.
  void add_cell(const Row &row, double (&w)[n], DiskCompliance<n> &W) const;
  /// Tells the cell of an impulse.
  void move_cell(const Row &row, const double (&change)[n]);

  double &velocity(const std::size_t body, const unsigned int component)
  {
    if constexpr (n == 4)
      if (component >= 3)
        return states[body].angular_velocity[component - 3];
    if constexpr (n > 1 && dim == 2)
      if (component == 2)
        return states[body].angular_velocity;
    return states[body].velocity[component];
  }
  /// Ranges of a colour from here to there, at the same time.
  template <class Work>
  void run(std::pair<std::uint32_t, std::uint32_t> some, const Work &work);
  /// Calls work(range, is_wall, index of the range): ranges of one colour at the same time, walls last. After
  /// each colour they tell each other what has changed.
  template <class Work>
  void for_ranges(const Work &work);
  /// Works on ranges as for_ranges(), but without word between colours: for work that only reads bodies.
  template <class Work>
  void for_ranges_at_once(const Work &work);
  template <class Work>
  void for_bodies(const Work &work);
  /// Calls work(packed row, index in the contacts) in the order of the rows.
  template <class Work>
  static void interleave(Range range, const Work &work);

  const Bodies &bodies;
  const Contacts &contacts;
  ThreadTeam &team;

  // Not vectors: those would fill them on one thread before all threads do.
  std::unique_ptr<Row[]> rows;
  std::unique_ptr<State[]> states;
  DiskCell cell, last_cell;
  std::unique_ptr<std::array<double, n_velocities>[]> last_velocity;
  std::vector<std::uint32_t> packed_of;   ///< of a body of the caller
  std::vector<std::uint32_t> original_of; ///< of a packed body
  std::vector<Range> ranges;              ///< by colour; the last one is the walls
  std::vector<std::uint32_t> colour_end;  ///< ranges before the end of each colour
  std::vector<std::uint32_t> wall_of;     ///< per contact with a wall, in the order of the rows
  unsigned int n_walls = 0;
  std::vector<double> sums, approach; ///< one per range
  std::optional<DiskShare> share;     ///< with others
  std::vector<std::array<double, n>> saved;
};

extern template class DiskSweeps<1>;
extern template class DiskSweeps<2>;
extern template class DiskSweeps<3>;
} // namespace softgrain::contact

#endif
