// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/body/point_layout.h>

#include <deal.II/base/symmetric_tensor.h>

namespace softgrain::mpm
{
template <int dim>
PointLayout<dim>::PointLayout(const PointNeeds &needs)
{
  const std::string length = dim == 2 ? "m^2" : "m^3";
  const std::vector<PointSlotDescription> all = {
      {PointSlot::body, "body", 1, ""},
      {PointSlot::rest_volume, "rest_volume", 1, length},
      {PointSlot::mass, "mass", 1, dim == 2 ? "kg/m" : "kg"},
      {PointSlot::half_extent, "half_extent", 1, "m"},
      {PointSlot::gradient, "deformation_gradient", dim * dim, ""},
      {PointSlot::velocity, "velocity", needs.velocity ? dim : 0u, "m/s"},
      {PointSlot::stress, "stress", dealii::SymmetricTensor<2, dim>::n_independent_components, "Pa"},
      {PointSlot::volume, "volume", needs.volume ? 1u : 0u, length},
      {PointSlot::affine, "affine_velocity", needs.affine ? dim * dim : 0u, "1/s"},
      {PointSlot::history, "history", needs.n_history, ""}};
  offsets.fill(none);
  for (const PointSlotDescription &description : all)
    if (description.n_components > 0)
    {
      offsets[static_cast<unsigned int>(description.slot)] = total;
      total += description.n_components;
      descriptions.push_back(description);
    }
}

template class PointLayout<2>;
template class PointLayout<3>;
} // namespace softgrain::mpm
