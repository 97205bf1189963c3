// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_analysis_internal_moments_h
#define softgrain_analysis_internal_moments_h

#include <softgrain/analysis/assembly.h>

#include <deal.II/base/symmetric_tensor.h>

namespace softgrain
{
/// Stress of the box, which must be there, from the internal moments of the bodies @cite nguyen2016, eqs.
/// (2.30)-(2.31) [Pa]. Arms reach from the centre of mass, so a body that accelerates adds nothing of its
/// own.
template <int dim>
dealii::SymmetricTensor<2, dim> stress_of_box(const AssemblyIn<dim> &assembly);

/// Strain rate times the time a body needs to fill a gap under the pressure @p p [Pa] @cite nguyen2016, eq.
/// (2.19); the rate is that of the walls that move fastest, along their normal or their tangent.
template <int dim>
double inertial_number(const AssemblyIn<dim> &assembly, double p);
} // namespace softgrain

#endif
