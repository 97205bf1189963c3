// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_gathered_primaries_h
#define softgrain_bpm_gathered_primaries_h

#include <softgrain/bpm/dynamics.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace softgrain::bpm
{
/**
 * @brief Primaries, contacts and bonds as snapshots see them: those of all owners, in the order of one
 * process.
 *
 * Where each owner has some of them, they are gathered to the first one; others see nothing.
 */
class GatheredPrimaries
{
public:
  /// A pair of primaries of one body.
  struct Bond
  {
    std::uint32_t a, b;
    double attraction; ///< 0 when out of range [N/m]
    double impulse;    ///< normal, of the last step [N s/m]
  };

  /// All make it. @p dynamics has to stay as it is.
  explicit GatheredPrimaries(const Dynamics &dynamics);

  const Primaries &disks() const { return gathered ? gathered->disks : dynamics.disks(); }
  /// b >= disks().size(): a wall, and obstacles after the walls.
  const contact::DiskContacts &rows() const { return gathered ? gathered->rows : dynamics.present().rows(); }
  double gap(const std::size_t row) const
  {
    return gathered ? gathered->gap[row] : dynamics.present().gaps()[row];
  }
  bool carries_force(const std::size_t row) const
  {
    return gathered || dynamics.present().carries_force(row);
  }
  /// Image of its second body that row @p row is a contact with; not one with a wall.
  PeriodicCell<2>::Image image_of_row(const std::size_t row) const
  {
    return gathered ? PeriodicCell<2>::Image() : dynamics.present().image_of_row(row);
  }

  /// Calls work(bond) for every pair of one body that has an attraction or an impulse.
  template <class Work>
  void for_bonds(const Work &work) const
  {
    if (!gathered)
      return for_bonds_here(0, dynamics.present().neighbours().n_pairs(), work);
    for (const Bond &bond : gathered->bonds)
      work(bond);
  }

private:
  template <class Work>
  void for_bonds_here(const std::size_t begin, const std::size_t end, const Work &work) const
  {
    const contact::NeighbourList &list = dynamics.present().neighbours();
    const std::vector<std::uint32_t> &body = dynamics.disks().body;
    for (std::size_t pair = begin; pair < end; ++pair)
    {
      const std::uint32_t a = list.a(pair), b = list.b(pair);
      if (body[a] != body[b])
        continue;
      const Bond bond = {a, b, dynamics.present().attraction_of(pair), list.memory()[pair][0]};
      if (bond.attraction != 0. || bond.impulse != 0.)
        work(bond);
    }
  }

  struct Gathered
  {
    Primaries disks;
    contact::DiskContacts rows; ///< that carry force; what describes them, not what solves them
    std::vector<double> gap;
    std::vector<Bond> bonds;
  };
  void gather_disks();
  void gather_rows();
  void gather_bonds();

  const Dynamics &dynamics;
  std::optional<Gathered> gathered; ///< where each owner has some
};
} // namespace softgrain::bpm

#endif
