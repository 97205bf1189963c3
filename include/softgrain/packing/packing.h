// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_packing_packing_h
#define softgrain_packing_packing_h

#include <softgrain/packing/size_distribution.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace softgrain
{
/// What makes a grain of a packing another one than a disk; it lies inside of the disk.
struct GrainForm2D
{
  enum class Kind
  {
    disk,
    ellipse,
    polygon ///< its corners lie on an ellipse, in even steps of its parameter: a regular one when that is a
            ///< disk
  };
  Kind kind = Kind::disk;
  double short_radius = 0;  ///< second semi-axis; the first is the radius of the disk around it [m]
  unsigned int corners = 0; ///< of a polygon
  double angle = 0;         ///< of the first axis, where a polygon has a corner; counter-clockwise [degrees]

  /// Directions of the corners of a polygon, as they would be on a unit circle.
  std::vector<dealii::Tensor<1, 2>> directions() const;
  /// @param radius of the disk around it [m] @return [m^2]
  double area(double radius) const;
  /// About the smallest distance of two parallel lines around it [m].
  double width(double radius) const;
};

/// Grains that do not overlap: what a scene with many bodies starts from.
template <int dim>
struct Packing
{
  /// A ball, in the plane a disk.
  struct Ball
  {
    dealii::Point<dim> center; ///< [m]
    double radius = 0;         ///< [m]
  };
  std::vector<Ball> balls;
  std::vector<GrainForm2D> forms; ///< of grains in the plane, inside of the disks; empty: they are the disks
  std::vector<std::string>
      materials;    ///< name of each grain's material; empty: the grains have none of their own
  std::string file; ///< that the grains were read from; empty: none
};

/// Area of all grains of a packing [m^2].
double solid_area(const Packing<2> &packing);

/// Volume of all balls of a packing [m^3].
double solid_volume(const Packing<3> &packing);

/// Form of a grain, that of a disk where there are no others.
GrainForm2D form_of(const Packing<2> &packing, std::size_t grain);

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

/// Which grains a packing is of; each kind that is asked for is drawn equally often.
struct GrainMix2D
{
  std::vector<GrainForm2D::Kind> kinds = {GrainForm2D::Kind::disk};
  double least_ratio = 1, greatest_ratio = 1;       ///< of the semi-axes, short over long
  unsigned int least_corners = 5, most_corners = 5; ///< of polygons

  bool only_disks() const { return kinds.size() == 1 && kinds[0] == GrainForm2D::Kind::disk; }
};

/// Grains of a packing that are alike.
struct GrainClass2D
{
  double share = 0;                      ///< of the grains, or of their area, over the sum of all shares
  double smallest = 0, largest = 0;      ///< diameters, uniform between these [m]
  std::string material;                  ///< empty: that of the packing
  std::optional<GrainForm2D::Kind> kind; ///< nothing: as the packing's mix says

  double mean_area() const; ///< [m^2]
};

/// What make_packing() is to make of balls, in the plane of disks.
template <int dim>
struct BallRequest
{
  unsigned int number = 0;
  SizeDistribution sizes;          ///< diameters; of other grains those of disks with their areas
  dealii::Point<dim> lower, upper; ///< box at the end [m]
  double fraction = 0; ///< of the box that the balls fill, their sizes scaled alike; 0: sizes as drawn
  std::uint64_t seed = 1;
};

/// What make_packing() is to make in the plane.
struct PackingRequest2D : BallRequest<2>
{
  std::vector<GrainClass2D> classes; ///< in place of sizes; the first class has the first grains
  bool shares_of_area = false;       ///< what the shares of classes count: numbers, or areas
  GrainMix2D mix;
  PackingProtocol protocol;

  bool only_disks() const;
  /// Number of grains of each class: shares rounded so that their sum is the number of all.
  /// @throw InputError when a class would have none
  std::vector<unsigned int> numbers() const;
};

/// What make_packing() is to make in space: balls.
struct PackingRequest3D : BallRequest<3>
{
  std::array<bool, 3> periodic{}; ///< directions without walls: what leaves at one side comes in at the other
};

/// Reads "share: diameter [to diameter] [, material] [, shape]; ..." of 'Packing/Classes'. @throw InputError
std::vector<GrainClass2D> parse_classes(const std::string &text);
/// Reads a table with the columns share,smallest_m,largest_m and, if it has them, material and shape. @throw
/// InputError
std::vector<GrainClass2D> read_classes(const std::string &file);

/**
 * @brief Disks of given @p radii [m] in the box from @p lower to @p upper, at random and without overlap.
 *
 * The disks are thrown at random into a larger box of the same shape, which then shrinks with everything in
 * it, a little at a time; the contact kernel keeps the disks apart. A thousandth of the mean radius is taken
 * from every radius at the end, so that no rounding makes disks overlap.
 *
 * About 0.80 is reached by this alone. Where that is too little, disks without friction are shaken, see
 * ShakenBalls: about 0.84.
 * @throw InputError when the disks do not fit into the box.
 */
Packing<2> pack_disks(const std::vector<double> &radii,
                      const dealii::Point<2> &lower,
                      const dealii::Point<2> &upper,
                      Uniform &random,
                      const PackingProtocol &protocol = {});

/**
 * @brief Disks, ellipses and polygons in the box from @p lower to @p upper, without overlap.
 *
 * The disks around them are thrown at random into a larger box of the same shape, which then shrinks while
 * the grains are shaken, see ShakenBox. All sizes are a thousandth smaller at the end, so that no rounding
 * makes grains overlap.
 * @param grains places and angles do not matter
 * @throw InputError when the grains do not fit into the box
 */
Packing<2>
pack_grains(Packing<2> grains, const dealii::Point<2> &lower, const dealii::Point<2> &upper, Uniform &random);

/// The radii that make_packing() draws; where there are others than disks, of disks with the same areas [m].
std::vector<double> draw_radii(const PackingRequest2D &request, Uniform &random);

/// pack_disks() with radii drawn at random, or pack_grains().
Packing<2> make_packing(const PackingRequest2D &request);

/**
 * @brief Balls of given @p radii [m] in the box from @p lower to @p upper, at random and without overlap.
 *
 * They are thrown into a larger box of the same shape, which shrinks while they are shaken, see ShakenBalls.
 * @throw InputError when they do not fit into the box
 */
Packing<3> pack_balls(const std::vector<double> &radii,
                      const dealii::Point<3> &lower,
                      const dealii::Point<3> &upper,
                      Uniform &random,
                      const std::array<bool, 3> &periodic = {});

/// The radii that make_packing() draws [m].
std::vector<double> draw_radii(const PackingRequest3D &request, Uniform &random);

/// pack_balls() with radii drawn at random.
Packing<3> make_packing(const PackingRequest3D &request);

/// Reads `x_m,y_m,radius_m` or `x_m,y_m,shape,a_m,b_m,corners,angle_deg`, in space `x_m,y_m,z_m,radius_m`,
/// each also with `,material`. @throw InputError naming file and line.
template <int dim>
Packing<dim> read_packing(const std::string &file);

/// Writes what read_packing() reads, whole or not at all. @throw InputError when it cannot be written.
template <int dim>
void write_packing(const std::string &file, const Packing<dim> &packing);

/// Whether @p file is there with just what write_packing() would write into it.
template <int dim>
bool holds_packing(const std::string &file, const Packing<dim> &packing);
} // namespace softgrain

#endif
