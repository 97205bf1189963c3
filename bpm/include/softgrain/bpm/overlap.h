// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_overlap_h
#define softgrain_bpm_overlap_h

#include <deal.II/base/point.h>

#include <cstdint>

namespace softgrain::bpm
{
/// A primary in something else.
struct Overlap
{
  enum class With
  {
    body,
    wall,
    obstacle
  };
  double depth = 0;       ///< [m]
  std::uint32_t body = 0; ///< of the primary
  With with = With::body;
  std::uint32_t other = 0; ///< number of that body, wall or obstacle
  dealii::Point<2> place;  ///< centre of the primary [m]
};
} // namespace softgrain::bpm

#endif
