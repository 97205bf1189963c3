// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/force_distribution.h>
#include <softgrain/analysis/measure.h>

#include <algorithm>
#include <numeric>

namespace softgrain
{
namespace
{
/// Normal forces between bodies: mean, largest, their probability density over the mean, and the fit
/// @cite nguyen2016, eqs. (2.32)-(2.33).
template <int dim>
class Forces final : public MeasureIn<dim>
{
public:
  std::vector<std::string> columns() const override
  {
    const std::string unit = dim == 2 ? "_N_per_m" : "_N";
    std::vector<std::string> names = {"mean_normal_force" + unit, "largest_normal_force" + unit,
                                      "force_fit_gamma", "force_fit_beta"};
    for (unsigned int b = 0; b < n_bins; ++b)
      names.push_back("force_density_at_" + std::to_string(b / 5) + "." + std::to_string(2 * (b % 5) + 1));
    return names;
  }

  std::vector<MeasuredValue> evaluate(const AssemblyIn<dim> &assembly) const override
  {
    std::vector<double> forces;
    for (const BodyContactIn<dim> &contact : assembly.contacts)
      if (!contact.with_wall() && contact.normal_force > 0.)
        forces.push_back(contact.normal_force);
    std::vector<MeasuredValue> result(4 + n_bins);
    if (forces.empty())
      return result;
    const double mean = std::accumulate(forces.begin(), forces.end(), 0.) / forces.size();
    result[0] = mean;
    result[1] = *std::max_element(forces.begin(), forces.end());
    std::vector<double> count(n_bins, 0.);
    for (double &force : forces)
    {
      force /= mean;
      if (force < n_bins * width)
        count[static_cast<unsigned int>(force / width)] += 1.;
    }
    if (const std::optional<double> gamma = fit_force_distribution(forces))
    {
      result[2] = gamma;
      result[3] = force_distribution_beta(*gamma);
    }
    for (unsigned int b = 0; b < n_bins; ++b)
      result[4 + b] = count[b] / (forces.size() * width);
    return result;
  }

private:
  static constexpr unsigned int n_bins = 20;
  static constexpr double width = 0.2; ///< of a bin, in units of the mean force
};

constexpr const char *name = "forces",
                     *description =
                         "normal forces between bodies: mean, largest, probability density and its fit";
[[maybe_unused]] const bool registered = register_measure<Forces<2>>(name, description),
                            registered_in_space = register_measure<Forces<3>, 3>(name, description);
} // namespace
} // namespace softgrain
