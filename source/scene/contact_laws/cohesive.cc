// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/scene/contact_law.h>

#include <deal.II/base/parameter_handler.h>

namespace softgrain
{
namespace
{
/// Dugdale's adhesion @cite maugis1992, a constant pull up to a gap h, so that the work of adhesion is
/// strength times h. It knows no past: what comes near is pulled as what goes away.
class Cohesive final : public ContactLaw
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry("Adhesion range", "0", dealii::Patterns::Double(0.),
                      "Gap up to which adhesion acts; 0: where surfaces touch. Units: m.");
  }

  void parse_parameters(const dealii::ParameterHandler &prm) override
  {
    reach = prm.get_double("Adhesion range");
  }

  bool adheres() const override { return true; }
  double range() const override { return reach; }
  double share(const double gap, double) const override { return gap <= reach ? 1. : 0.; }
  double mean_share(const double start, const double end, double) const override
  {
    return part_within(reach, start, end);
  }

private:
  double reach = 0; ///< [m]
};

[[maybe_unused]] const bool registered =
    Registry<ContactLaw>::instance().add("cohesive",
                                         "surfaces nearer than 'Adhesion range' are held together by "
                                         "'Adhesion', and slide with friction times what "
                                         "presses them together, that included",
                                         [] { return std::make_unique<Cohesive>(); });
} // namespace
} // namespace softgrain
