// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/internal_moments.h>
#include <softgrain/analysis/measure.h>

#include <cmath>

namespace softgrain
{
namespace
{
/// Stress of the box in space from internal moments, with p = -tr/3 and q = (3/2)^(1/2) |deviator|, and the
/// pressures on its walls, whose mean is the same p at rest.
class StressInSpace final : public MeasureIn<3>
{
public:
  std::vector<std::string> columns() const override
  {
    std::vector<std::string> names = {"stress_xx_Pa", "stress_yy_Pa",     "stress_zz_Pa", "stress_xy_Pa",
                                      "stress_xz_Pa", "stress_yz_Pa",     "stress_1_Pa",  "stress_2_Pa",
                                      "stress_3_Pa",  "mean_pressure_Pa", "deviator_Pa",  "stress_ratio"};
    for (const char *const side : Box<3>::sides)
      names.push_back(std::string(side) + "_pressure_Pa");
    names.insert(names.end(), {"wall_pressure_Pa", "inertial_number"});
    return names;
  }

  std::vector<MeasuredValue> evaluate(const AssemblyIn<3> &assembly) const override
  {
    std::vector<MeasuredValue> result(20);
    if (!assembly.box || assembly.snapshot.bodies.empty())
      return result;
    const dealii::SymmetricTensor<2, 3> stress = stress_of_box(assembly);
    const double p = -trace(stress) / 3., q = std::sqrt(1.5) * deviator(stress).norm();
    result = {stress[0][0], stress[1][1], stress[2][2], stress[0][1], stress[0][2], stress[1][2]};
    // The greatest pressure first, counted as compression.
    const std::array<double, 3> principal = eigenvalues(stress);
    result.insert(result.end(), {-principal[2], -principal[1], -principal[0], p, q,
                                 p > 0. ? MeasuredValue(q / p) : std::nullopt});
    double sum = 0.;
    for (unsigned int w = 0; w < 6; ++w)
    {
      const double pressure = find_wall(assembly.snapshot.walls, Box<3>::sides[w])->normal_force *
                              assembly.box->edge[w / 2] / assembly.box->volume();
      result.emplace_back(pressure);
      sum += pressure;
    }
    result.emplace_back(sum / 6.);
    result.emplace_back(p > 0. ? MeasuredValue(inertial_number(assembly, p)) : std::nullopt);
    return result;
  }
};

[[maybe_unused]] const bool registered = register_measure<StressInSpace, 3>(
    "stress", "stress of the box from internal moments and from its walls, p, q, inertial number");
} // namespace
} // namespace softgrain
