// SPDX-License-Identifier: LGPL-2.1-or-later
// Adhesion that falls linearly from its strength, where surfaces touch, to nothing at 'Fading range'.
#include <softgrain/scene/contact_law.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

using namespace softgrain;

class Fading final : public ContactLaw
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry("Fading range", "1", dealii::Patterns::Double(1e-300),
                      "Gap at which adhesion ends. Units: m.");
  }

  void parse_parameters(const dealii::ParameterHandler &prm) override
  {
    end = prm.get_double("Fading range");
  }

  bool adheres() const override { return true; }
  double range() const override { return end; }
  double share(const double gap, double) const override { return std::max(0., 1. - gap / end); }

private:
  double end = 1;
};

[[maybe_unused]] const bool registered = Registry<ContactLaw>::instance().add(
    "fading", "adhesion that falls linearly with the gap", [] { return std::make_unique<Fading>(); });
