// SPDX-License-Identifier: LGPL-2.1-or-later
// An ellipse, of which softgrain is told no more than parameters and outline.
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/shape.h>
#include <softgrain/parameters/parameter_values.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>

using namespace softgrain;

class Oval final : public Shape<2>
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    using namespace dealii::Patterns;
    prm.declare_entry("Half axes", "0, 0", List(Double(0), 2, 2, ","),
                      "Half the width and height. Units: m.");
  }

  void parse_parameters(const dealii::ParameterHandler &prm, const Place &body_center) override
  {
    center = body_center;
    half = pair_of_numbers(prm.get("Half axes"));
  }

  void check(const std::string &body) const override
  {
    if (!(half[0] > 0. && half[1] > 0.))
      throw InputError("'" + body + "/Half axes' leaves the body empty: both must be greater than 0");
  }

  std::vector<Polygon> outline(const double spacing) const override
  {
    const unsigned int n = std::max(16., std::ceil(2. * M_PI * std::max(half[0], half[1]) / spacing));
    Polygon loop;
    for (unsigned int i = 0; i < n; ++i)
    {
      const double angle = 2. * M_PI * i / n;
      loop.emplace_back(center[0] + half[0] * std::cos(angle), center[1] + half[1] * std::sin(angle));
    }
    return {loop};
  }

private:
  Place center;
  dealii::Tensor<1, 2> half;
};

[[maybe_unused]] const bool registered =
    Registry<Shape<2>>::instance().add("oval", "Center, Half axes", [] { return std::make_unique<Oval>(); });
