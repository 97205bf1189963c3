// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_body_cost_h
#define softgrain_mpm_model_body_cost_h

#include <softgrain/mpm/model/settings.h>
#include <softgrain/scene/crowd.h>

namespace softgrain::mpm
{
/// What a body costs, judged by its size before it is made.
struct BodyCost
{
  /// Processor time of a point in one iteration of Newton's method, and how much more where bodies meet;
  /// fitted to runs of the shipped scenes on one thread.
  static constexpr double point_seconds = 0.33e-6, contact_seconds = 0.38e-6;

  double points = 0., unknowns = 0.;
  double factor_seconds = 0.;   ///< of its matrix, in one iteration of Newton's method
  double condense_seconds = 0.; ///< of one body to its contact rows
  double memory = 0.;           ///< [bytes]

  /// Processor time of one iteration of Newton's method in an assembly.
  double iteration_seconds() const { return (point_seconds + contact_seconds) * points + factor_seconds; }
};

BodyCost cost_of(const BodyGroup &body, const Settings &settings);
} // namespace softgrain::mpm

#endif
