// SPDX-License-Identifier: LGPL-2.1-or-later
// Two elastic-plastic balls in a box that becomes lower, and one between two plates. The mirror image,
// exchanged names, two threads, forces in another unit, and runs that are continued are the same. A step that
// is given up leaves nothing behind in the points. What walls do is stored or lost, and half the step comes
// nearer to it. A ball yields first as Hertz's field says, and bears what a known fit of finite elements
// says.
#include "continued.h"
#include "two_balls.h"

#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>

using namespace softgrain;
using namespace softgrain::mpm;

namespace
{
using Changes = std::vector<std::string>;

Changes and_more(Changes changes, const Changes &more)
{
  changes.insert(changes.end(), more.begin(), more.end());
  return changes;
}

Changes metal(const double unit)
{
  const std::string law = "Materials/gel/J2 plastic/";
  return {"Materials/gel/Law=j2_plastic", law + "Young's modulus=" + std::to_string(unit),
          law + "Poisson's ratio=0.3", law + "Yield stress=" + std::to_string(0.03125 * unit),
          law + "Kinematic modulus=" + std::to_string(0.0625 * unit)};
}

std::vector<double> kept_by_points(const Model<3> &model)
{
  std::vector<double> all;
  for (const NamedField &field : model.snapshot().points.extra)
    all.insert(all.end(), field.values.begin(), field.values.end());
  return all;
}

std::string steps(Model<3> &model, const unsigned int from, const unsigned int to, const double unit = 1.)
{
  std::ostringstream text;
  text << std::hexfloat;
  for (unsigned int i = from; i < to; ++i)
  {
    StepReport report = model.advance(0.3);
    model.settle(report);
    const Snapshot<3> state = model.snapshot();
    text << model.time() << ' ' << report.newton_iterations << ' ' << state.energies.elastic / unit << ' '
         << state.energies.dissipated / unit << ' ' << state.energies.external_work / unit;
    for (const auto &wall : model.walls())
      text << ' ' << wall.normal_force / unit;
    dealii::SymmetricTensor<2, 3> stress;
    for (const auto &of_point : state.points.stress)
      stress += of_point;
    text << ' ' << stress / unit;
    for (const NamedField &field : state.points.extra)
      for (const double value : field.values)
        text << ' ' << value;
    text << '\n';
  }
  return text.str();
}

std::unique_ptr<Model<3>> metal_model(const Changes &more, const double unit = 1.)
{
  std::ofstream("scene.prm") << two;
  return model_of("scene.prm", and_more(metal(unit), more));
}

void same_bits(const std::string &what, const Changes &changes)
{
  const unsigned int n = 6;
  const std::string one = steps(*metal_model(changes), 0, n);
  set_n_threads(2);
  const std::string two_threads = steps(*metal_model(changes), 0, n);
  set_n_threads(1);
  const std::string parts = continued_twice(
      n, [&] { return metal_model(changes); },
      [](Model<3> &model, const unsigned int from, const unsigned int to) { return steps(model, from, to); });
  std::cout << what << ": two threads same " << (two_threads == one) << ", continued twice same "
            << (parts == one) << ", in another unit same "
            << (steps(*metal_model(changes, 1024.), 0, n, 1024.) == one) << '\n';
}

void images()
{
  // Balance is found so exactly that what is left tells no image from another.
  const Changes exact = and_more(metal(1.), {"Newton/Residual tolerance=1e-8"});
  const Outcome pressed = two_balls(exact);
  std::cout << "balance within 1e-3 " << (pressed.left_over < 1e-3) << ", bottom and top off by "
            << below(1e-3, pressed.forces[0] / pressed.forces[1] - 1.) << ", energy off by "
            << below(0.03, pressed.energy) << '\n';
  const Outcome image =
      two_balls(and_more(exact, {"Bodies/a/Center=-0.12, -0.08, 2.4", "Bodies/b/Center=0.21, 0.13, 7.3"}));
  std::cout << "mirror image off by " << below(1e-8, off(pressed, image, {0, 1, 3, 2, 4, 5})) << '\n';
  const Outcome exchanged =
      two_balls(and_more(exact, {"Bodies/a/Center=-0.21, 0.13, 7.3", "Bodies/a/Radius=2.5",
                                 "Bodies/b/Center=0.12, -0.08, 2.4", "Bodies/b/Radius=2.3"}));
  std::cout << "exchanged off by " << below(1e-8, off(pressed, exchanged, {0, 1, 2, 3, 4, 5})) << '\n';
}

/// Half the step: less of what walls do is in no account.
void shorter_steps()
{
  double missing[2];
  for (const unsigned int half : {0, 1})
    missing[half] =
        std::abs(two_balls(and_more(metal(1.), {half ? "Time/Wall way=0.15" : "Time/Wall way=0.3"})).energy);
  std::cout << "half the step, energy off by less " << (missing[1] < 0.7 * missing[0]) << '\n';
}

void given_up()
{
  const auto failing = metal_model({"Quasi-static/Held steps=1", "Quasi-static/Unbalanced force=1e-12"});
  std::vector<double> before = kept_by_points(*failing);
  try
  {
    for (double time = 0.; time < 2.; time = failing->time())
    {
      before = kept_by_points(*failing);
      StepReport report = failing->advance(0.3);
      failing->settle(report);
    }
  }
  catch (const ComputationError &)
  {
    std::cout << "given up, points as before " << (kept_by_points(*failing) == before) << '\n';
  }
}
} // namespace

int main()
{
  set_n_threads(1);
  images();
  shorter_steps();
  given_up();
  same_bits("smooth", {});
  same_bits("rough", {"Contact/Friction=0.3", "Contact/Friction at walls=same"});
}
