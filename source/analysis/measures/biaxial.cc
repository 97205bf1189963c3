// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/box_measures.h>
#include <softgrain/analysis/measure.h>

namespace softgrain
{
namespace
{
/// Strains of the box since the first snapshot and stresses on its walls, with the signs of
/// @cite nguyen2016, section 5.3: shortening and compression are positive.
class Biaxial final : public Measure
{
public:
  std::vector<std::string> columns() const override
  {
    return {"strain_1",    "strain_2",         "shear_strain",     "volume_strain",    "stress_1_Pa",
            "stress_2_Pa", "wall_pressure_Pa", "wall_deviator_Pa", "wall_stress_ratio"};
  }

  std::vector<MeasuredValue> evaluate(const Assembly &assembly) const override
  {
    std::vector<MeasuredValue> result(9);
    const std::vector<WallState<2>> &walls = assembly.snapshot.walls;
    if (assembly.context.first != nullptr)
      if (const auto strain = box_strain(assembly.context.first->walls, walls))
      {
        result[0] = strain->along_height;
        result[1] = strain->along_width;
        result[2] = strain->shear();
        result[3] = strain->volume();
      }
    if (const auto stress = box_stress(walls))
    {
      result[4] = stress->along_height;
      result[5] = stress->along_width;
      result[6] = stress->mean();
      result[7] = stress->deviator();
      if (stress->mean() > 0.)
        result[8] = stress->deviator() / stress->mean();
    }
    return result;
  }
};

[[maybe_unused]] const bool registered = register_measure<Biaxial>(
    "biaxial", "strains of the box since the start, stresses on its walls, p, q with its sign");
} // namespace
} // namespace softgrain
