// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_plane_compliance_h
#define softgrain_mpm_contact_plane_compliance_h

#include <softgrain/mpm/body/body.h>

namespace softgrain::mpm
{
/// (1-ν²)/E of a body at rest, by which Hertz's law counts it; 0 of a driven body, which is rigid [1/Pa].
template <int dim>
double plane_compliance(const Body<dim> &body)
{
  if (body.rigid.driven)
    return 0.;
  const double nu = body.material.law->poisson_ratio();
  return (1. - nu * nu) / body.material.law->young_modulus();
}
} // namespace softgrain::mpm

#endif
