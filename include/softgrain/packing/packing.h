// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_packing_packing_h
#define softgrain_packing_packing_h

#include <softgrain/packing/size_distribution.h>

#include <deal.II/base/point.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace softgrain
{
/// Disks that do not overlap: what a scene with many bodies starts from.
struct Packing
{
  struct Disk
  {
    dealii::Point<2> center; ///< [m]
    double radius = 0;       ///< [m]
  };
  std::vector<Disk> disks;
  std::vector<std::string>
      materials;    ///< name of each disk's material; empty: the disks have none of their own
  std::string file; ///< that the disks were read from; empty: none

  double solid_area() const;
};

/// How disks are brought into their box.
struct PackingProtocol
{
  /// Whether the box shrinks in ever smaller steps once the disks jam; else it is given up at once, from
  /// about 0.75 on.
  bool patient = true;
  /**
   * Whether the box shrinks until the disks carry its sides, as under a pressure (how high does not matter to
   * rigid disks); then box and disks are scaled to the box wanted.
   */
  bool jam = false;
  double friction = 0.;           ///< between disks, and with walls
  std::array<bool, 2> periodic{}; ///< directions without walls: what leaves at one side comes in at the other
};

/// What make_packing() is to make.
struct PackingRequest
{
  unsigned int number = 0;
  SizeDistribution sizes;
  dealii::Point<2> lower, upper; ///< box at the end [m]
  double fraction = 0; ///< of the box that the disks fill, their sizes scaled alike; 0: sizes as drawn
  std::uint64_t seed = 1;
  PackingProtocol protocol;
};

/**
 * @brief Disks of given @p radii [m] in the box from @p lower to @p upper, at random and without overlap.
 *
 * The disks are thrown at random into a larger box of the same shape, which then shrinks with everything in
 * it, a little at a time; the contact kernel keeps the disks apart. A thousandth of the mean radius is taken
 * from every radius at the end, so that no rounding makes disks overlap.
 *
 * About 0.80 is reached without friction, 0.84 when jammed.
 * @throw InputError when the disks do not fit into the box.
 */
Packing pack_disks(const std::vector<double> &radii,
                   const dealii::Point<2> &lower,
                   const dealii::Point<2> &upper,
                   Uniform &random,
                   const PackingProtocol &protocol = {});

/// The radii that make_packing() draws [m].
std::vector<double> draw_radii(const PackingRequest &request, Uniform &random);

/// pack_disks() with radii drawn at random.
Packing make_packing(const PackingRequest &request);

/// Reads `x_m,y_m,radius_m` or `x_m,y_m,radius_m,material`. @throw InputError naming file and line.
Packing read_packing(const std::string &file);

/// Writes what read_packing() reads, whole or not at all. @throw InputError when it cannot be written.
void write_packing(const std::string &file, const Packing &packing);
} // namespace softgrain

#endif
