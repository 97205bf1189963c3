// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_load_h
#define softgrain_scene_load_h

#include <softgrain/base/registry.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
/// The matter that a load is asked for.
template <int dim>
struct LoadPlace
{
  dealii::Point<dim> now;          ///< where it is [m]
  dealii::Point<dim> at_rest;      ///< where it was at the start; of loads that see no velocity [m]
  dealii::Tensor<1, dim> velocity; ///< of loads that see it [m/s]
  double time = 0;                 ///< [s]
};

/**
 * @brief What acts on all matter: a force per mass. Every member of the family has parameters in section
 * `Loads`, and acts on every body where these ask for it.
 *
 * Work that a load does is booked under its name, in the column NAME_work of a history.
 */
template <int dim>
class Load
{
public:
  virtual ~Load() = default;

  std::string name; ///< in the registry, and of the column of its work; given by who makes it
  /// The parameter in section `Loads` that makes it act, "Drag/Rate"; for messages.
  virtual std::string key() const = 0;

  /// Declares its parameters; the handler stands in section `Loads`.
  virtual void declare_parameters(dealii::ParameterHandler &prm) const = 0;
  /// Reads them; the handler stands there. @throw InputError
  virtual void parse_parameters(dealii::ParameterHandler &prm) = 0;

  /// Whether its parameters make it act.
  virtual bool acts() const = 0;

  /// Force per mass; asked for on several threads at once [N/kg].
  virtual dealii::Tensor<1, dim> acceleration(const LoadPlace<dim> &place) const = 0;

  /// Whether it is the same at all places and velocities; it may change with time.
  virtual bool is_uniform() const { return false; }

  /// Whether it depends on the velocity. Steps then take it where matter is halfway and with its mean
  /// velocity, and at the nodes, as inertia is; without inertia velocities mean nothing, and it is refused.
  virtual bool sees_velocity() const { return false; }

  /// Derivative of acceleration() with respect to the velocity [1/s].
  virtual dealii::Tensor<2, dim> velocity_tangent(const LoadPlace<dim> &) const { return {}; }
};

template <>
Registry<Load<2>> &Registry<Load<2>>::instance();
template <>
Registry<Load<3>> &Registry<Load<3>>::instance();

/// Registers a member in the plane and in space. @tparam Member takes the dimension
template <template <int> class Member>
bool add_load(const std::string &name, const std::string &description)
{
  const bool plane =
      Registry<Load<2>>::instance().add(name, description, [] { return std::make_unique<Member<2>>(); });
  return Registry<Load<3>>::instance().add(name, description, [] { return std::make_unique<Member<3>>(); }) &&
         plane;
}
} // namespace softgrain

#endif
