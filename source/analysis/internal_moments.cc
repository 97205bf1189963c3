// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/internal_moments.h>

#include <cmath>

namespace softgrain
{
template <int dim>
dealii::SymmetricTensor<2, dim> stress_of_box(const AssemblyIn<dim> &assembly)
{
  const Snapshot<dim> &snapshot = assembly.snapshot;
  dealii::Tensor<2, dim> moment;
  for (const ContactState<dim> &contact : snapshot.contacts)
  {
    if (contact.body_a == contact.body_b)
      continue;
    moment += outer_product(contact.force, contact.place - snapshot.bodies[contact.body_a].center);
    if (contact.wall == ContactState<dim>::not_a_body)
      moment -= outer_product(contact.force,
                              contact.place - snapshot.bodies[contact.body_b].center - contact.image);
  }
  return symmetrize(moment) / assembly.box->volume();
}

template <int dim>
double inertial_number(const AssemblyIn<dim> &assembly, const double p)
{
  double mass = 0., volume = 0., diameter = 0.;
  for (unsigned int b = 0; b < assembly.snapshot.bodies.size(); ++b)
  {
    mass += assembly.snapshot.bodies[b].mass;
    volume += assembly.snapshot.bodies[b].reference_area;
    diameter += assembly.rest_diameter(b) / assembly.snapshot.bodies.size();
  }
  return assembly.box->strain_rate() * diameter * std::sqrt(mass / volume / p);
}

template dealii::SymmetricTensor<2, 2> stress_of_box<2>(const AssemblyIn<2> &);
template dealii::SymmetricTensor<2, 3> stress_of_box<3>(const AssemblyIn<3> &);
template double inertial_number<2>(const AssemblyIn<2> &, double);
template double inertial_number<3>(const AssemblyIn<3> &, double);
} // namespace softgrain
