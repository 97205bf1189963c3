// SPDX-License-Identifier: LGPL-2.1-or-later
// Held steps in a circle: a body goes on where its resistance is large, and back where it is too small.
// Resistance falls after every good step, so that the body goes back every fourth step and never arrives.
// After a dozen steps without a better balance resistance falls less far each time, until the body arrives. A
// body that never goes back arrives in a few steps, with a resistance that falls all the way.
#include <softgrain/mpm/model/problem.h>
#include <softgrain/mpm/model/state.h>
#include <softgrain/mpm/stepping/relaxation.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace softgrain::mpm;

namespace
{
/// One node on its way from 0 to 1: a mock of bodies in a long valley.
class Valley
{
public:
  /// @param enough resistance below which it is thrown back by twice its last way
  explicit Valley(const double enough) : enough(enough)
  {
    state.bodies.emplace_back();
    state.bodies[0].displacement = Eigen::VectorXd::Zero(2);
  }

  /// Number of held steps until it arrives, @p most when it does not.
  unsigned int go(const unsigned int most)
  {
    Problem problem;
    Relaxation relaxation(problem, state, 1.);
    double before = unbalanced();
    for (unsigned int n = 1; n <= most; ++n)
    {
      const double resistance = relaxation.plan().regularisation;
      double &x = state.bodies[0].displacement[0];
      way = resistance < enough ? -2. * way : std::min(1e-3 / resistance, 0.5 * (1. - x));
      x += way;
      lowest = std::min(lowest, resistance);
      if (1. - x < 1e-3)
        return n;
      StepOutcome step;
      step.accepted = true;
      step.newton_iterations = 7;
      const double after = unbalanced();
      relaxation.accepted(step, state, before, after, false);
      before = after;
    }
    return most;
  }

  double lowest = 1.; ///< resistance on the way

private:
  /// Falls only at the end of the way.
  double unbalanced() const { return std::min(1e-3, 1e-2 * (1. - state.bodies[0].displacement[0])); }

  State state;
  const double enough;
  double way = 1e-3; ///< in the last step
};
} // namespace

int main()
{
  constexpr unsigned int most = 1000;
  for (const double enough : {0., 0.02, 0.05})
  {
    Valley valley(enough);
    const unsigned int steps = valley.go(most);
    std::cout << "thrown back below a resistance of " << enough << ": arrives " << (steps < most)
              << ", held steps " << steps << ", lowest resistance " << valley.lowest << '\n';
  }
}
