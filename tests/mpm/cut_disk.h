// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_mpm_cut_disk_h
#define softgrain_tests_mpm_cut_disk_h

// A disk whose rim cuts cells, so that some of them are extended, and its stiffness: for tests of tangents.
#include "scene_of.h"

#include <softgrain/linear/system_matrix.h>
#include <softgrain/mpm/stepping/stiffness.h>

namespace softgrain
{
/// The parameter file of the disk, of material m. @param rest sections that it does not have
inline std::string cut_disk(const std::string &rest)
{
  return R"(
subsection Mesh
  set Lower = 0, 0
  set Upper = 8, 8
  set Cell size = 1
end
subsection Bodies
  set Names = d
  subsection d
    set Center = 4.13, 3.91
    set Radius = 2.3
  end
end
subsection Stop
  set End time = 1
end
)" + rest;
}

/// The stiffness of a body at evaluated points, times a nodal vector.
inline Eigen::VectorXd
stiffness_times(const mpm::Body<2> &body, const mpm::StepState<2> &points, const Eigen::VectorXd &nodal)
{
  SystemMatrix matrix;
  lay_out_stiffness(body.field, matrix, false);
  matrix.set_zero();
  mpm::add_stiffness(body, points, 1., matrix);
  return matrix.lower().selfadjointView<Eigen::Lower>() * nodal;
}
} // namespace softgrain

#endif
