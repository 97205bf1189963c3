// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/anisotropy.h>
#include <softgrain/analysis/measure.h>

namespace softgrain
{
namespace
{
/// Directions of the contacts between bodies and the normal forces in them @cite nguyen2016, eqs.
/// (2.27)-(2.28) and (5.12)-(5.16), and the tangential ones.
class Fabric final : public Measure
{
public:
  std::vector<std::string> columns() const override
  {
    return {"fabric_xx",
            "fabric_yy",
            "fabric_xy",
            "contact_anisotropy",
            "contact_direction_rad",
            "normal_force_anisotropy",
            "half_sum_of_anisotropies",
            "tangential_force_anisotropy",
            "predicted_stress_ratio"};
  }

  std::vector<MeasuredValue> evaluate(const Assembly &assembly) const override
  {
    dealii::SymmetricTensor<2, 2> fabric, forces, all_forces;
    double n = 0., force = 0.;
    for (const BodyContact &contact : assembly.contacts)
    {
      if (contact.with_wall())
        continue;
      const dealii::SymmetricTensor<2, 2> nn = symmetrize(outer_product(contact.normal, contact.normal));
      fabric += nn;
      n += 1.;
      forces += contact.normal_force * nn;
      all_forces += symmetrize(outer_product(contact.force, contact.normal));
      force += contact.normal_force;
    }
    std::vector<MeasuredValue> result(9);
    if (n == 0.)
      return result;
    fabric /= n;
    const double anisotropy = 2. * eigenvalue_difference(fabric);
    result = {fabric[0][0], fabric[1][1], fabric[0][1], anisotropy,  principal_angle(fabric),
              std::nullopt, std::nullopt, std::nullopt, std::nullopt};
    if (force > 0.)
    {
      result[5] = 2. * eigenvalue_difference(forces / force) - anisotropy;
      result[6] = 0.5 * (anisotropy + *result[5]);
      result[7] = 2. * eigenvalue_difference(all_forces / force) - anisotropy - *result[5];
      result[8] = *result[6] + 0.5 * *result[7];
    }
    return result;
  }
};

[[maybe_unused]] const bool registered = register_measure<Fabric>(
    "fabric", "fabric tensor, anisotropy of contacts and of normal forces between bodies");
} // namespace
} // namespace softgrain
