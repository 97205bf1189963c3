// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_packing_packing_method_h
#define softgrain_packing_packing_method_h

#include <softgrain/base/registry.h>
#include <softgrain/packing/packing.h>

#include <optional>

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
  double smallest = 0;    ///< diameter [m]
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

  /// Whether the disks may come with materials of their own.
  virtual bool may_name_materials() const { return false; }

  /// What make() is expected to bring, within a moment; nothing when it cannot say.
  /// @throw InputError when a file cannot be read
  virtual std::optional<ExpectedGrains> expected() const { return std::nullopt; }

  /// The disks; may take long, on all threads. @throw InputError when they do not fit or cannot be read.
  virtual Packing<dim> make() const = 0;
};

template <>
Registry<PackingMethod<2>> &Registry<PackingMethod<2>>::instance();
} // namespace softgrain

#endif
