// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_point_data_h
#define softgrain_constitutive_point_data_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <cstddef>

namespace softgrain::constitutive
{
/// What a batch of points tells a law: arrays of the caller with one entry (or one row of history) per point.
template <int dim>
struct Inputs
{
  std::size_t n_points = 0;
  /// F at the end of the step, from the stress-free state. Small-strain laws do not read it.
  const dealii::Tensor<2, dim> *deformation_gradient = nullptr;
  /// Displacement gradient over the step, F F_old^-1 - I. Finite-strain laws do not read it.
  const dealii::Tensor<2, dim> *increment = nullptr;
  /// n_points rows of Law::n_history() values at the start of the step; may be null when there are none.
  const double *history_old = nullptr;
  /// Length of the step [s]. 0: the state at hand is asked for, and nothing flows, relaxes or grows.
  double dt = 0;
  /// Time at the end of the step [s].
  double time = 0;
};

/**
 * @brief Where a law writes its answer: arrays of the caller with one entry (or one row of history) per
 * point.
 *
 * A null pointer means not wanted and costs nothing, so that an explicit step never pays for tangents. An
 * output array may not overlap an input array, with one exception: history_new may be history_old.
 */
template <int dim>
struct Outputs
{
  /// Kirchhoff stress tau (finite strain) or Cauchy stress sigma (small strain) [Pa].
  dealii::SymmetricTensor<2, dim> *stress = nullptr;
  /**
   * Finite strain: spatial modulus c with L_v tau = c : d [Pa], L_v the Lie derivative
   * (L_v tau = d tau/dt - l tau - tau l^T), so that the stiffness is
   * grad_s dN : c : grad_s N + grad dN . tau . grad N per reference volume.
   * Small strain: C with d sigma = C : d eps [Pa].
   */
  dealii::SymmetricTensor<4, dim> *tangent = nullptr;
  /// Stress normal to the plane in plane strain (tau_zz or sigma_zz) [Pa]; not written when dim = 3.
  double *out_of_plane_stress = nullptr;
  /// Stored energy per reference volume [J/m^3].
  double *energy = nullptr;
  /// Energy dissipated over the step per reference volume [J/m^3], never negative.
  double *dissipation = nullptr;
  /// n_points rows of Law::n_history() values at the end of the step.
  double *history_new = nullptr;
  /// One number for the batch, which a law with Law::limits_step() lowers to the largest share of dt that it
  /// allows: below 1 the step is tried again shorter. The other outputs are valid nevertheless.
  double *step_share = nullptr;
  /// Energy that laws with Law::is_active() bring in over the step per reference volume [J/m^3]; may be
  /// negative. It starts from 0 for laws that do not write it.
  double *supply = nullptr;
};
} // namespace softgrain::constitutive

#endif
