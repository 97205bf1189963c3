// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_analysis_box_measures_h
#define softgrain_analysis_box_measures_h

#include <softgrain/analysis/snapshot.h>

#include <optional>
#include <vector>

namespace softgrain
{
/// ln(h0/h) of the distance of bottom and top; nothing without these walls.
template <int dim>
std::optional<double> axial_strain(const std::vector<WallState<dim>> &start,
                                   const std::vector<WallState<dim>> &now);

/// Logarithmic strains of the box since @p start, shortening positive as in the thesis: e1 along the height,
/// e2 along the width.
struct BoxStrain
{
  double along_height = 0; ///< e1 = ln(h0/h)
  double along_width = 0;  ///< e2 = ln(w0/w)

  double shear() const { return along_height - along_width; }  ///< e_q = e1 - e2
  double volume() const { return along_height + along_width; } ///< e_v = e1 + e2
};

/// Strain of the box; there is none unless both states have the walls bottom, top, left and right.
std::optional<BoxStrain> box_strain(const std::vector<WallState<2>> &start,
                                    const std::vector<WallState<2>> &now);

/// Stresses on the walls, compression positive @cite nguyen2016, eqs. (5.7)-(5.8).
struct BoxStress
{
  double along_height = 0; ///< s1, mean of bottom and top [Pa]
  double along_width = 0;  ///< s2, mean of left and right [Pa]

  double mean() const { return 0.5 * (along_height + along_width); }     ///< p [Pa]
  double deviator() const { return 0.5 * (along_height - along_width); } ///< q, with its sign [Pa]
};

/// Stress of the box; there is none unless bottom, top, left and right are there.
std::optional<BoxStress> box_stress(const std::vector<WallState<2>> &walls);

/// @p solid_area, in space a volume, over that of the box; nothing unless all its walls are there.
template <int dim>
std::optional<double> packing_fraction(const std::vector<WallState<dim>> &walls, double solid_area);
} // namespace softgrain

#endif
