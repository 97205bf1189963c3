// SPDX-License-Identifier: LGPL-2.1-or-later
// An ellipse pressed between two plates: the width of the contact is that of a line contact with the radius
// of curvature where it touches, a^2/b when it lies and b^2/a when it stands. The half width is twice the
// root of the mean square distance of the pressure from the middle.
#include "scene_of.h"

#include <softgrain/base/mpi_session.h>

#include <iostream>

using namespace softgrain;

namespace
{
const double pi = std::acos(-1.), modulus = 1e6, ratio = 0.3;

void look(const std::string &what,
          const double half_height,
          const double radius,
          const double cell,
          const double strain)
{
  std::ostringstream scene;
  scene << "subsection Mesh\n  set Lower = -12e-3, -12e-3\n  set Upper = 12e-3, 12e-3\n  set Cell size = "
        << cell
        << "\nend\nsubsection Materials\n  set Names = gel\n  subsection gel\n    set Law = neo_hookean\n    "
           "subsection "
           "Neo-Hookean\n      set Young's modulus = 1e6\n      set Poisson's ratio = 0.3\n    end\n  "
           "end\nend\n"
           "subsection Bodies\n  set Names = grain\n  subsection grain\n    set Shape = ellipse\n    set "
           "Semi-axes = "
           "10e-3, 6e-3\n    set Angle = "
        << (half_height < 8e-3 ? 0 : 90)
        << "\n  end\nend\nsubsection Walls\n  set Names = bottom, top\n  subsection "
        << "bottom\n    set Point = 0, " << -half_height << "\n  end\n  subsection top\n    set Point = 0, "
        << half_height
        << "\n    set Velocity = 1\n  end\nend\nsubsection Time\n  set Scheme = quasi_static\n  set Time "
           "step = "
        << half_height * strain / 5. << "\nend\nsubsection Stop\n  set End time = 1\nend\n";
  const auto model = scene_of_text(scene.str());
  run_until(*model, 2. * half_height * strain);
  const Snapshot<2> state = model->snapshot();
  double force = 0., square = 0.;
  for (const ContactState<2> &contact : state.contacts)
    if (contact.wall == 0)
    {
      force += contact.force[1];
      square += contact.force[1] * contact.place[0] * contact.place[0];
    }
  const double half_width = 2. * std::sqrt(square / force), effective = modulus / (1. - ratio * ratio);
  const double expected = std::sqrt(4. * force * radius / (pi * effective));
  std::cout << what << ": half width over that of a line contact " << half_width / expected
            << ", force below over force above " << force / model->walls()[1].normal_force << '\n';
}
} // namespace

int main(int, char **argv)
{
  const softgrain::MPISession mpi(argv);
  look("lies", 6e-3, 100e-6 / 6e-3, 0.5e-3, 0.03);
  look("stands", 10e-3, 36e-6 / 10e-3, 0.25e-3, 0.03);
}
