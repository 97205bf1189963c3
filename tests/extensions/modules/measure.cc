// SPDX-License-Identifier: LGPL-2.1-or-later
// How many bodies there are.
#include <softgrain/analysis/measure.h>

using namespace softgrain;

class NumberOfBodies final : public Measure
{
public:
  std::vector<std::string> columns() const override { return {"number_of_bodies"}; }

  std::vector<MeasuredValue> evaluate(const Assembly &assembly) const override
  {
    return {static_cast<double>(assembly.snapshot.bodies.size())};
  }
};

[[maybe_unused]] const bool registered =
    register_measure<NumberOfBodies>("number_of_bodies", "bodies of the scene");
