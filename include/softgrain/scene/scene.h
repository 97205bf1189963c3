// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_scene_h
#define softgrain_scene_scene_h

#include <softgrain/base/expression.h>
#include <softgrain/geometry/curve.h>
#include <softgrain/scene/loads.h>
#include <softgrain/scene/pair_table.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <string>
#include <vector>

namespace softgrain
{
class ContactLaw;
class ObstacleDrive;
class RigidSurface;
template <int dim>
class PackingMethod;
template <int dim>
class Shape;
template <>
class Shape<2>;
template <>
class Shape<3>;
class WallDrive;

/// A material as the scene names it; the law itself is created by the model from `law` and the law's own
/// subsection.
struct MaterialDescription
{
  std::string name;
  std::string law;      ///< name in the registry of laws
  double density = 0.0; ///< at rest [kg/m^3]
};

/// One body of the scene.
template <int dim>
struct BodyDescription
{
  std::string name;
  unsigned int material = 0;               ///< index into Scene::materials
  std::shared_ptr<const Shape<dim>> shape; ///< at the start, in its place
  dealii::Point<dim> center;               ///< about which it turns [m]
  std::string velocity;                    ///< initial velocity, expressions of x, y: "vx; vy" [m/s]
  double angular_velocity = 0;             ///< added about the centre, counter-clockwise [rad/s]
  std::string body_force;                  ///< expressions of x, y (now), X, Y (at rest), t: "bx; by" [N/kg]
  bool driven = false;                     ///< moves rigidly with its initial velocity, whatever it meets
};

/// A straight rigid wall; the domain lies on the side its normal points to.
template <int dim>
struct WallDescription
{
  enum class Type
  {
    plane,           ///< exact plane
    material_points, ///< a slab of material points that moves rigidly, as in the thesis
    periodic         ///< side of a cell that repeats: bodies go through it, it moves as other walls do
  };

  std::string name;
  Type type = Type::plane;
  dealii::Point<dim> point;               ///< a point of the plane at the start [m]
  dealii::Tensor<1, dim> normal;          ///< unit, into the domain
  std::shared_ptr<const WallDrive> drive; ///< how it moves
  std::string drive_name;                 ///< in the registry of drives, for messages
  double friction = 0;                    ///< with bodies that the table of pairs does not name with it
};

/// A rigid line of finite length that bodies may touch from both sides.
template <int dim>
struct ObstacleDescription
{
  std::string name;
  std::vector<Curve> pieces;      ///< as drawn; each begins where the one before it ends
  dealii::Point<dim> pivot;       ///< about which it turns, before it is displaced [m]
  std::vector<Expression> motion; ///< formulas of t: displacement [m], angle [degrees]
  double friction = 0;
  std::shared_ptr<const ObstacleDrive> drive; ///< beside these; null: it goes as they say
};

/// A rigid sheet in space that bodies may touch from both sides.
template <>
struct ObstacleDescription<3>
{
  std::string name;
  std::shared_ptr<const RigidSurface> surface; ///< as drawn
  dealii::Point<3> pivot;         ///< on the axis about which it turns, before it is displaced [m]
  dealii::Tensor<1, 3> axis;      ///< about which it turns, unit
  std::vector<Expression> motion; ///< formulas of t: displacement [m], angle [degrees]
  double friction = 0;
  std::shared_ptr<const ObstacleDrive> drive; ///< beside these; null: it goes as they say
};

/// Many grains at once, made when everything else is known to be right; see add_packing().
template <int dim>
struct PackingDescription
{
  std::shared_ptr<const PackingMethod<dim>> method; ///< null: no packing
  std::string material;                             ///< of grains whose file names none; empty: the only one
  std::string save_to;                              ///< file for the grains; empty: none
};

/// What a parameter file says of the world: bodies, walls and loads. Nothing of how it is solved.
template <int dim>
struct Scene
{
  std::vector<MaterialDescription> materials;
  std::vector<BodyDescription<dim>> bodies; ///< with those of the packing, once it is made
  PackingDescription<dim> packing;
  std::vector<WallDescription<dim>> walls;
  std::vector<ObstacleDescription<dim>> obstacles;
  Loads<dim> loads;    ///< on all bodies
  double friction = 0; ///< between bodies, where the table of pairs says nothing
  std::vector<PairValue> friction_pairs;
  std::shared_ptr<const ContactLaw> contact_law; ///< null: Coulomb's
  double adhesion = 0; ///< strength where the table says nothing [N/m^2]; between primaries [N/m]
  std::vector<PairValue> adhesion_pairs;
  double end_time = 0; ///< of the run, if it has one [s]
};
} // namespace softgrain

#endif
