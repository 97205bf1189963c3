// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_body_point_layout_h
#define softgrain_mpm_body_point_layout_h

#include <array>
#include <string>
#include <vector>

namespace softgrain::mpm
{
/// Everything that a material point may carry from grid to grid; what a step computes lives in StepState.
enum class PointSlot : unsigned int
{
  body,        ///< index of its body
  rest_volume, ///< at rest
  mass,        ///< density times rest volume
  half_extent, ///< half the edge of the domain at rest
  gradient,    ///< F from rest to the configuration of the grid, by rows
  velocity,    ///< when the grid was laid; with inertia only
  stress,      ///< as the law returns it, end of the last step, in the order of dealii::SymmetricTensor
  volume,      ///< small-strain laws only: when the grid was laid
  affine,      ///< APIC matrix, when wanted, by rows
  history      ///< the law's own, end of the last step
};

/// What one slot holds.
struct PointSlotDescription
{
  PointSlot slot;
  std::string name; ///< in files
  unsigned int n_components;
  std::string unit;
};

/// What a scene asks its points to carry beyond the rest.
struct PointNeeds
{
  bool velocity = true; ///< of bodies with inertia
  bool volume = false;  ///< of their own, beside the rest volume and F
  bool affine = false;
  unsigned int n_history = 0; ///< largest number of history values of all laws
};

/**
 * @brief Where each slot lies among the properties of a point: the one description that storage, checkpoints
 * and access go by. Slots that a scene does not need take no room.
 */
template <int dim>
class PointLayout
{
public:
  explicit PointLayout(const PointNeeds &needs = PointNeeds());

  /// Slots that points have, in the order in which they lie.
  const std::vector<PointSlotDescription> &slots() const { return descriptions; }
  /// Doubles per point.
  unsigned int n_components() const { return total; }
  bool has(const PointSlot slot) const { return offset(slot) != none; }
  /// First double of a slot.
  unsigned int offset(const PointSlot slot) const { return offsets[static_cast<unsigned int>(slot)]; }

private:
  static constexpr unsigned int none = static_cast<unsigned int>(-1);
  static constexpr unsigned int n_slots = static_cast<unsigned int>(PointSlot::history) + 1;

  std::vector<PointSlotDescription> descriptions;
  std::array<unsigned int, n_slots> offsets;
  unsigned int total = 0;
};
} // namespace softgrain::mpm

#endif
