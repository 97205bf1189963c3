// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_packing_packing_method_h
#define softgrain_packing_packing_method_h

#include <softgrain/base/registry.h>
#include <softgrain/packing/packing.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
/// What a packing will bring, as far as that is known before it is made.
struct ExpectedGrains
{
  double number = 0;
  double mean_volume = 0; ///< in the plane an area [m^dim]
  double smallest = 0;    ///< width of the thinnest: the diameter of a disk [m]
  std::string thinnest;   ///< its name as a body, as "grain_3"; empty: not known before it is made
  std::map<std::string, double> of_material; ///< how many have a material of their own; empty: none
};

/**
 * @brief A way to come by many grains: `Packing/Method` names a member of this family.
 */
template <int dim>
class PackingMethod
{
public:
  virtual ~PackingMethod() = default;

  /// Declares its parameters where the handler stands, in section `Packing`.
  virtual void declare_parameters(dealii::ParameterHandler &prm) const = 0;

  /// Reads and checks them; nothing is packed yet. @throw InputError
  virtual void parse_parameters(dealii::ParameterHandler &prm) = 0;

  /// Whether parameters that were read ask for it where 'Method' is left at automatic.
  virtual bool asked_for(const dealii::ParameterHandler &) const { return false; }

  /// Whether the disks may come with materials of their own, when parameters have been read.
  virtual bool may_name_materials() const { return false; }

  /// Names of the materials that grains are known to have, before they are made.
  virtual std::vector<std::string> named_materials() const { return {}; }

  /// What make() is expected to bring, within a moment; nothing when it cannot say.
  /// @throw InputError when a file cannot be read
  virtual std::optional<ExpectedGrains> expected() const { return std::nullopt; }

  /// The disks; may take long, on all threads. @throw InputError when they do not fit or cannot be read.
  virtual Packing<dim> make() const = 0;
};

template <>
Registry<PackingMethod<2>> &Registry<PackingMethod<2>>::instance();
template <>
Registry<PackingMethod<3>> &Registry<PackingMethod<3>>::instance();
} // namespace softgrain

#endif
