// SPDX-License-Identifier: LGPL-2.1-or-later
// The thesis's own method on its diametral compression, on a mesh of cells of R/8. Known: Johnson's line
// contact, approach per side F (1-nu^2)/(pi E) (2 ln(4R/a) - 1) with a^2 = 4 F R (1-nu^2)/(pi E). Contact as
// soon as a node is shared gives about twice that force at small strain; with the gap the rest is the error
// of so coarse a mesh.
#include <softgrain/app/input.h>

#include <cmath>
#include <iostream>

namespace
{
/// Force [N/m] of line contact for an approach per side [m].
double johnson(const double approach)
{
  const double radius = 5e-3, modulus = 10e6 / (1. - 0.45 * 0.45);
  double low = 1e-3, high = 1e7;
  for (unsigned int i = 0; i < 100; ++i)
  {
    const double force = std::sqrt(low * high), a = std::sqrt(4. * force * radius / (M_PI * modulus));
    (force / (M_PI * modulus) * (2. * std::log(4. * radius / a) - 1.) < approach ? low : high) = force;
  }
  return low;
}

void compress(const std::string &gap)
{
  softgrain::Input input(
      SOFTGRAIN_SOURCE_DIR "/parameters/thesis/diametral_compression_mpm_thesis_method.prm",
      {"Mesh/Cell size=6.25e-4", "Mesh/Lower=-7.5e-3, -8.125e-3", "Mesh/Upper=7.5e-3, 8.125e-3",
       "Contact/Nodal gap=" + gap, "Output directory=results"});
  const auto model = input.create_model();
  double bottom = 0., top = 0., time = 0.;
  // Waves cross the disk several times within the window that the forces are averaged over.
  const double start = 0.6e-3, end = 0.8e-3;
  while (model->time() < end)
  {
    const double dt = model->advance(end - model->time()).dt;
    if (model->time() < start)
      continue;
    const auto walls = model->walls();
    bottom += walls[0].normal_force * dt;
    top += walls[1].normal_force * dt;
    time += dt;
  }
  const double expected = johnson(0.5 * 0.2 * 0.5 * (start + end)), least = gap == "true" ? 0.8 : 1.5,
               most = gap == "true" ? 1.4 : 3.;
  const auto within = [&](const double force)
  { return force > least * expected && force < most * expected ? "yes" : "no"; };
  const softgrain::Energies energies = model->energies();
  const double lost =
      1. - (energies.kinetic + energies.elastic + energies.dissipated) / energies.external_work;
  std::cout << "gap " << gap << ": force over Johnson's between " << least << " and " << most << ", bottom "
            << within(bottom / time) << ", top " << within(top / time) << ", momentum kept "
            << (model->momentum_error() < 1e-10 ? "yes" : "no") << ", work kept "
            << (lost > -0.01 && lost < 0.1 ? "yes" : "no") << '\n';
}
} // namespace

int main()
{
  compress("true");
  compress("false");
}
