// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/scene/contact_law.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <limits>

namespace softgrain
{
namespace
{
/// A glue that holds until it is torn off or sheared off. The memory of a contact is 1 where it holds, and
/// the share of the healing time that it has been pressed where it does not.
class Bond final : public ContactLaw
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    using namespace dealii::Patterns;
    prm.declare_entry("Adhesion range", "0", Double(0.),
                      "Gap up to which adhesion acts; 0: where surfaces touch. Units: m.");
    prm.declare_entry(
        "Healing time", "never", Anything(),
        "Time for which surfaces must be pressed together until they hold; 0: they hold as soon "
        "as they touch; never: only what touches when the run starts holds. Units: s.");
  }

  void parse_parameters(const dealii::ParameterHandler &prm) override
  {
    reach = prm.get_double("Adhesion range");
    const std::string text = prm.get("Healing time");
    if (text == "never")
      return;
    if (!dealii::Patterns::Double(0.).match(text))
      throw InputError("'Contact/Healing time' = '" + text +
                       "' is not allowed: it must be 'never' or a number of seconds, 0 or more");
    healing_time = prm.get_double("Healing time");
  }

  bool adheres() const override { return true; }
  double range() const override { return reach; }
  double share(const double gap, const double memory) const override
  {
    return memory >= 1. && gap <= reach ? 1. : 0.;
  }
  double mean_share(const double start, const double end, const double memory) const override
  {
    return memory >= 1. ? part_within(reach, start, end) : 0.;
  }

  bool remembers() const override { return true; }
  double memory_at_start() const override { return 1.; }
  double memory_after(const double memory, const ContactEvent &event) const override
  {
    if (memory >= 1.)
      return event.gap > reach || event.slides ? 0. : 1.;
    if (!event.closed || healing_time == std::numeric_limits<double>::infinity())
      return 0.;
    return healing_time > 0. ? std::min(1., memory + event.dt / healing_time) : 1.;
  }

private:
  double reach = 0;                                              ///< [m]
  double healing_time = std::numeric_limits<double>::infinity(); ///< [s]
};

[[maybe_unused]] const bool registered = Registry<ContactLaw>::instance().add(
    "bond",
    "as cohesive, but a contact that has opened by more than 'Adhesion range', or has slid, holds no more "
    "until it has healed",
    [] { return std::make_unique<Bond>(); });
} // namespace
} // namespace softgrain
