// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_geometry_uncovered_arcs_h
#define softgrain_geometry_uncovered_arcs_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace softgrain
{
/// A disk of a union.
struct DiskOfUnion
{
  dealii::Point<2> center; ///< [m]
  double radius;           ///< [m]
};

/// A part of a disk's edge that no other disk covers, counter-clockwise between two neighbours.
struct UncoveredArc
{
  static constexpr unsigned int none = static_cast<unsigned int>(-1);

  unsigned int disk, from, to;     ///< `from` is none on a disk that nobody touches
  double length;                   ///< 4 for a full turn, without trigonometry
  dealii::Tensor<1, 2> begin, end; ///< unit directions from the centre
};

/// All uncovered arcs of the union of @p disks, in their order; there is one disk at least.
std::vector<UncoveredArc> uncovered_arcs(const std::vector<DiskOfUnion> &disks);
} // namespace softgrain

#endif
