// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_analysis_anisotropy_h
#define softgrain_analysis_anisotropy_h

#include <deal.II/base/symmetric_tensor.h>

#include <optional>

namespace softgrain
{
/// Larger minus smaller eigenvalue, to rounding also where they are nearly the same.
double eigenvalue_difference(const dealii::SymmetricTensor<2, 2> &tensor);

/// Angle of the direction of the larger eigenvalue, in (-pi/2, pi/2]; nothing when rounding decides it [rad].
std::optional<double> principal_angle(const dealii::SymmetricTensor<2, 2> &tensor);
} // namespace softgrain

#endif
