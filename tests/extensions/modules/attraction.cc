// SPDX-License-Identifier: LGPL-2.1-or-later
// An attraction that falls linearly from contact to the end of its range.
#include <softgrain/bpm/attraction.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

using namespace softgrain;

class FallingAttraction final : public bpm::Attraction
{
public:
  std::string title() const override { return "Falling"; }

  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.declare_entry("Largest force", "1", dealii::Patterns::Double(0), "At contact. Units: N/m.");
  }

  void parse_parameters(dealii::ParameterHandler &prm) override { largest = prm.get_double("Largest force"); }
  double range() const override { return 2.; }
  double contact_force() const override { return largest; }

  void evaluate(const std::size_t n,
                const double *distance,
                const double *sum,
                double *force,
                double *energy) const override
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      const double left = std::clamp(2. - distance[i] / sum[i], 0., 1.);
      force[i] = largest * left;
      if (energy != nullptr)
        energy[i] = -0.5 * largest * sum[i] * left * left - largest * std::max(0., sum[i] - distance[i]);
    }
  }

private:
  double largest = 1.;
};

[[maybe_unused]] const bool registered = Registry<bpm::Attraction>::instance().add(
    "falling", "falls linearly", [] { return std::make_unique<FallingAttraction>(); });
