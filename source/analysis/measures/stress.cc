// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/anisotropy.h>
#include <softgrain/analysis/internal_moments.h>
#include <softgrain/analysis/measure.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
namespace
{
/// Stress of the box from the internal moments of the bodies @cite nguyen2016, eqs. (2.30)-(2.31), with p and
/// q of eqs. (5.7)-(5.8). Arms reach from the centre of mass, so a body that accelerates adds nothing of its
/// own.
class Stress final : public Measure
{
public:
  std::vector<std::string> columns() const override
  {
    return {"stress_xx_Pa",     "stress_yy_Pa",      "stress_xy_Pa",       "mean_pressure_Pa",
            "deviator_Pa",      "stress_ratio",      "bottom_pressure_Pa", "top_pressure_Pa",
            "left_pressure_Pa", "right_pressure_Pa", "inertial_number"};
  }

  std::vector<MeasuredValue> evaluate(const Assembly &assembly) const override
  {
    std::vector<MeasuredValue> result(11);
    if (!assembly.box || assembly.snapshot.bodies.empty())
      return result;
    const Snapshot<2> &snapshot = assembly.snapshot;
    const dealii::SymmetricTensor<2, 2> stress = stress_of_box(assembly);
    const double p = -0.5 * trace(stress), q = 0.5 * eigenvalue_difference(stress);
    result[0] = stress[0][0];
    result[1] = stress[1][1];
    result[2] = stress[0][1];
    result[3] = p;
    result[4] = q;
    for (const WallState<2> &wall : snapshot.walls)
      for (unsigned int w = 0; w < 4; ++w)
        if (columns()[6 + w] == wall.name + "_pressure_Pa")
          result[6 + w] = wall.normal_force / (w < 2 ? assembly.box->width() : assembly.box->height());
    if (p > 0.)
    {
      result[5] = q / p;
      result[10] = inertial_number(assembly, p);
    }
    return result;
  }
};

[[maybe_unused]] const bool registered = register_measure<Stress>(
    "stress", "stress of the box from internal moments and from its walls, p, q, inertial number");
} // namespace
} // namespace softgrain
