// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/measure.h>

#include <cmath>

namespace softgrain
{
namespace
{
/// Directions of the contacts between bodies in space: the mean of n n, its eigenvalues, and the anisotropy a
/// of the density (1 + n·A n)/4π of directions, A = 15/2 times the deviator, a = (3/2 A:A)^(1/2). A density
/// that goes as 1 + a (cos² - 1/3) about an axis has this a.
class FabricInSpace final : public MeasureIn<3>
{
public:
  std::vector<std::string> columns() const override
  {
    return {"fabric_xx", "fabric_yy", "fabric_zz", "fabric_xy", "fabric_xz",
            "fabric_yz", "fabric_1",  "fabric_2",  "fabric_3",  "contact_anisotropy"};
  }

  std::vector<MeasuredValue> evaluate(const AssemblyIn<3> &assembly) const override
  {
    dealii::SymmetricTensor<2, 3> fabric;
    double n = 0.;
    for (const BodyContactIn<3> &contact : assembly.contacts)
    {
      if (contact.with_wall())
        continue;
      fabric += symmetrize(outer_product(contact.normal, contact.normal));
      n += 1.;
    }
    if (n == 0.)
      return std::vector<MeasuredValue>(10);
    fabric /= n;
    const std::array<double, 3> principal = eigenvalues(fabric); // falling
    return {fabric[0][0], fabric[1][1],
            fabric[2][2], fabric[0][1],
            fabric[0][2], fabric[1][2],
            principal[0], principal[1],
            principal[2], 7.5 * std::sqrt(1.5) * deviator(fabric).norm()};
  }
};

[[maybe_unused]] const bool registered = register_measure<FabricInSpace, 3>(
    "fabric", "fabric tensor, its eigenvalues, and anisotropy of contacts between bodies");
} // namespace
} // namespace softgrain
