// SPDX-License-Identifier: LGPL-2.1-or-later
// What a contact law gives along a row whose gap changes linearly: the share of every law that is shipped,
// and of one that gives the share at a place alone, beside a numerical integration; the two halves of a row.
#include <softgrain/driving/adhesion.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <string>

using namespace softgrain;

namespace
{
constexpr double range = 2e-4, strip = 1e-6;

/// Falls linearly to 0 at the range, and says nothing of rows.
class Fading final : public ContactLaw
{
public:
  bool adheres() const override { return true; }
  double range() const override { return ::range; }
  double share(const double gap, double) const override { return std::max(0., 1. - gap / ::range); }
};

std::shared_ptr<const ContactLaw> law_named(const std::string &name)
{
  dealii::ParameterHandler prm;
  declare_contact_laws(prm);
  prm.set("Law", name);
  prm.set("Adhesion range", range);
  return parse_contact_law(prm);
}

/// The mean of 200 001 places; surfaces that overlap touch.
double integrated(const ContactLaw &law, const double start, const double end, const double memory)
{
  constexpr unsigned int places = 200001;
  double sum = 0.;
  for (unsigned int k = 0; k < places; ++k)
    sum += law.share(std::max(0., start + (k + 0.5) / places * (end - start)), memory);
  return sum / places;
}

/// Gaps at the ends of a row: within, beyond, across, level, overlapping, one of them at the range.
const std::array<std::array<double, 2>, 9> rows = {{{{0., 1e-4}},
                                                    {{3e-4, 5e-4}},
                                                    {{1e-4, 3e-4}},
                                                    {{5e-4, 0.}},
                                                    {{1.5e-4, 1.5e-4}},
                                                    {{2.5e-4, 2.5e-4}},
                                                    {{-4e-5, 4e-4}},
                                                    {{-3e-5, -1e-5}},
                                                    {{2e-4, 2.5e-4}}}};

void look(const std::string &name, const ContactLaw &law, const double memory)
{
  double furthest = 0.;
  std::cout << name << ", memory " << memory << ':';
  for (const auto &[start, end] : rows)
  {
    const double mean = law.mean_share(start, end, memory);
    furthest = std::max({furthest, std::abs(mean - integrated(law, start, end, memory)),
                         std::abs(mean - law.mean_share(end, start, memory))});
    std::cout << ' ' << mean;
  }
  std::cout << "; from the integral at most " << (furthest < 1e-5 ? 0. : furthest) << '\n';
}
} // namespace

int main()
{
  look("cohesive", *law_named("cohesive"), 0.);
  for (const double memory : {0., 0.5, 1.})
    look("bond", *law_named("bond"), memory);
  // Sixteen places are exact where the share is linear. Across a kink they are off by its change of slope
  // over 8 * 16^2 at most, here 2.5 / 2048.
  const Fading fading;
  look("by places", fading, 0.);
  const double infinity = std::numeric_limits<double>::infinity();
  std::cout << "to where there is nothing: " << law_named("cohesive")->mean_share(0., infinity, 0.) << ' '
            << fading.mean_share(0., infinity, 0.) << '\n';

  // The middle is within range by 0.5e-4; the halves go up to their ends by what is named, or to nothing.
  const auto of_halves =
      [](const Adhesion &adhesion, const double gap, const double before, const double after)
  {
    const double memory = adhesion.first_memory(gap);
    return 0.5 *
           (adhesion.mean_share(memory, gap, gap + before) + adhesion.mean_share(memory, gap, gap + after));
  };
  const Adhesion adhesion(law_named("cohesive"), strip);
  std::cout << "row of two halves: " << of_halves(adhesion, 1.5e-4, 0., 1e-4) << ' '
            << of_halves(adhesion, 1.5e-4, 2e-4, 1e-4) << ' ' << of_halves(adhesion, 1.5e-4, -1e-4, infinity)
            << '\n';
  // A range that the model cannot tell from touching: the middle counts.
  const Adhesion coarse(law_named("cohesive"), 2. * range);
  std::cout << "as a whole: " << of_halves(coarse, 1.5 * range, 1., 1.) << ' '
            << of_halves(coarse, 2.5 * range, -1., -1.) << '\n';
}
