// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_loads_h
#define softgrain_scene_loads_h

#include <softgrain/scene/load.h>

#include <memory>
#include <string>
#include <vector>

namespace softgrain
{
/// The loads that act on a body, or on all bodies of a scene.
template <int dim>
class Loads
{
public:
  using List = std::vector<std::shared_ptr<const Load<dim>>>;

  /// Declares the parameters of all members of the family, in section `Loads`; the handler stands at its top.
  static void declare_parameters(dealii::ParameterHandler &prm);
  /// Those that act. @throw InputError
  static Loads parse_parameters(dealii::ParameterHandler &prm);

  void add(const std::shared_ptr<const Load<dim>> &load) { list.push_back(load); }

  bool empty() const { return list.empty(); }
  std::size_t size() const { return list.size(); }
  typename List::const_iterator begin() const { return list.begin(); }
  typename List::const_iterator end() const { return list.end(); }
  std::vector<std::string> names() const;

  bool see_velocity() const;
  /// Whether some are asked for at every point: they depend on the place, and not on the velocity.
  bool look_at_points() const;
  /// Sum of those that are the same everywhere [N/kg].
  dealii::Tensor<1, dim> uniform(double time) const;
  /// Sum of all [N/kg].
  dealii::Tensor<1, dim> acceleration(const LoadPlace<dim> &place) const;

private:
  List list;
};

/// Whether a load is asked for at points.
template <int dim>
bool looks_at_points(const Load<dim> &load)
{
  return !load.is_uniform() && !load.sees_velocity();
}

/**
 * @brief Mean force per mass over a step of @p dt that begins at @p place, of a scheme that knows no velocity
 * but that of the start: what the load alone changes it by, exactly where it is linear in the velocity. Drag
 * stops nothing beyond its rest, and what turns velocities keeps them as fast as they are [N/kg].
 */
template <int dim>
dealii::Tensor<1, dim> mean_acceleration(const Load<dim> &load, const LoadPlace<dim> &place, double dt);

/// The load of a body's own, "bx; by", formulas of x, y, X, Y and t [N/kg]; null when they are the default.
/// @throw InputError
std::shared_ptr<const Load<2>> body_force(const std::string &formulas);
/// Name of that load.
constexpr const char *name_of_body_force = "body_force";
} // namespace softgrain

#endif
