// SPDX-License-Identifier: LGPL-2.1-or-later
// Loads that see the velocity, on primaries that nothing touches, against their closed forms. Drag alone is
// exact whatever the step. With a weight halving the step quarters the error. In a frame that turns it halves
// it: places go with the velocity at the end of a step. Drag that is far too strong for a step brings a
// primary to rest and not beyond.
#include "bpm_scene.h"

#include <softgrain/driving/works.h>

#include <iomanip>
#include <iostream>

using namespace softgrain;

namespace
{
std::string single()
{
  return R"(
subsection Materials
  set Names = m
  subsection m
    set Law     = power_law
    set Density = 2
    subsection Power law
      set Force at contact = 0
    end
  end
end
subsection Primaries
  set Smallest diameter = 1
  set Largest diameter  = 1
  set Number per body   = 1
end
subsection Stop
  set End time = 1000
end
)" + disks({{"2, 1", "0.3; -0.2"}}, "0.5");
}

struct Run
{
  Run(const Changes &changes, const double dt, const double end)
  {
    std::ostringstream step;
    step << "Time/Time step=" << dt;
    Changes all = changes;
    all.push_back(step.str());
    model = bpm_scene(single(), all);
    start = model->energies();
    while (model->time() < end - 1e-9)
      model->advance(end - model->time());
  }
  BodyState<2> body() const { return model->snapshot().bodies[0]; }
  double work() const
  {
    double sum = 0.;
    for (const auto &[name, value] : model->works())
      sum += value;
    return sum;
  }
  std::string books() const
  {
    return "energy " + below(1e-13, energy_error(start, model->energies())) + ", momentum " +
           below(1e-13, model->momentum_error());
  }
  std::unique_ptr<bpm::BpmModel> model;
  Energies start;
};

dealii::Tensor<1, 2> turned(const dealii::Tensor<1, 2> &v, const double angle)
{
  return dealii::Tensor<1, 2>(
      {std::cos(angle) * v[0] - std::sin(angle) * v[1], std::sin(angle) * v[0] + std::cos(angle) * v[1]});
}

void show(const std::string &what, const dealii::Tensor<1, 2> &expected, const Run &coarse, const Run &fine)
{
  const double error = (fine.body().velocity - expected).norm(),
               ratio = (coarse.body().velocity - expected).norm() / error;
  std::cout << what << ": velocity off by " << error << ", that of twice the step over it " << ratio << ", "
            << fine.books() << '\n';
}
} // namespace

int main()
{
  std::cout << std::setprecision(2);
  const dealii::Tensor<1, 2> v0({0.3, -0.2}), wind({0.1, 0.4});
  const Changes drag = {"Loads/Drag/Rate=3", "Loads/Drag/Velocity=0.1; 0.4"};
  const Run dragged(drag, 0.1, 0.5);
  std::cout << "drag: velocity off by "
            << below(1e-14, (dragged.body().velocity - wind - std::exp(-1.5) * (v0 - wind)).norm()) << ", "
            << dragged.books() << '\n';
  Changes sinks = drag;
  sinks.push_back("Loads/Gravity=0, -1");
  const dealii::Tensor<1, 2> steady = wind + dealii::Tensor<1, 2>({0., -1. / 3.});
  show("drag and weight", steady + std::exp(-1.5) * (v0 - steady), Run(sinks, 0.02, 0.5),
       Run(sinks, 0.01, 0.5));

  const Changes frame = {"Loads/Rotating frame/Angular velocity=0.5", "Loads/Rotating frame/Center=1, -1"};
  const dealii::Tensor<1, 2> arm({1., 2.}), outside = v0 + 0.5 * dealii::Tensor<1, 2>({-2., 1.}),
                                            end = turned(arm + 2. * outside, -1.);
  show("a frame that turns", turned(outside, -1.) - 0.5 * dealii::Tensor<1, 2>({-end[1], end[0]}),
       Run(frame, 0.02, 2.), Run(frame, 0.01, 2.));

  const Run stopped({"Loads/Drag/Rate=1e6"}, 0.01, 0.5);
  const BodyState<2> body = stopped.body();
  std::cout << "strong drag: way " << body.center.distance(dealii::Point<2>(2., 1.)) << " m, "
            << stopped.books() << '\n';

  // Both loads at once, each with its work.
  Changes both = drag;
  both.insert(both.end(), frame.begin(), frame.end());
  both.push_back("Loads/Gravity=0, -1");
  const Run all(both, 0.01, 0.5);
  std::cout << "three loads:";
  for (const auto &[name, value] : all.model->works())
    std::cout << ' ' << name;
  std::cout << ", " << all.books() << ", sum over the external work less 1 "
            << below(1e-13, all.work() / all.model->energies().external_work - 1.) << '\n';
}
