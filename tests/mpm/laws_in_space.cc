// SPDX-License-Identifier: LGPL-2.1-or-later
// Laws that know time, and plastic impacts, in space. A Maxwell ball between plates that stand relaxes as its
// modulus does. A ball grows freely; its law asks for shorter steps, and what it brings in is booked. A
// plastic ball that is thrown at a wall comes back with a smaller share of its speed the faster it was.
// Momentum is kept to rounding, and energy the better the shorter steps are. A run that is continued is the
// same to the last bit.
#include "continued.h"
#include "moving_balls.h"

namespace
{
using Changes = std::vector<std::string>;

const std::string plates = R"(
set Dimension = 3
subsection Mesh
  set Lower = -3, -3, -3
  set Upper = 3, 3, 3
  set Cell size = 0.7
end
subsection Time
  set Scheme = quasi_static
  set Time step = 0.1
end
)" + gel("0.3", "1", "1") + R"(subsection Bodies
  set Names = a
  subsection a
    set Shape  = sphere
    set Radius = 2
  end
end
subsection Walls
  set Names = bottom, top
  subsection bottom
    set Point = 0, 0, -2
  end
  subsection top
    set Point    = 0, 0, 2
    set Drive    = position
    set Position = 0.2*min(t/1e-6, 1)
  end
end
subsection Stop
  set End time = 10
end
)";

std::unique_ptr<Model<3>> made(const std::string &text, const Changes &changes)
{
  std::ofstream("scene.prm") << text;
  return model_of("scene.prm", changes);
}

void go(Model<3> &model, const double end)
{
  while (model.time() < end * (1. - 1e-12))
  {
    StepReport report = model.advance(end - model.time());
    model.settle(report);
  }
}

double column(const Model<3> &model, const std::string &wanted)
{
  for (const auto &columns : {model.extra_history(), model.works()})
    for (const auto &[name, value] : columns)
      if (name == wanted)
        return value;
  return -1.;
}

void relax()
{
  const std::string law = "Materials/gel/Maxwell/";
  const auto model = made(plates, {"Materials/gel/Law=maxwell", law + "Young's modulus=1",
                                   law + "Poisson's ratio=0.3", law + "Shares=0.5, 0.3",
                                   law + "Relaxation times=0.5, 4", "Contact/Sub-grid compliance=false"});
  go(*model, 1e-6);
  const double at_once = model->walls()[1].normal_force;
  const Energies before = model->energies();
  go(*model, 2.);
  const double modulus = 0.2 + 0.5 * std::exp(-2. / 0.5) + 0.3 * std::exp(-2. / 4.);
  const Energies e = model->energies();
  std::cout << "held: force / expected " << model->walls()[1].normal_force / (at_once * modulus)
            << ", dissipated since / fall of the energy "
            << (e.dissipated - before.dissipated) / (before.elastic - e.elastic) << '\n';
}

void grow()
{
  const std::string law = "Materials/gel/Growth/";
  const auto model =
      made(plates, {"Materials/gel/Law=growth", law + "Young's modulus=1", law + "Poisson's ratio=0.3",
                    law + "Rate=0.3", "Walls/bottom/Point=0, 0, -2.5", "Walls/top/Point=0, 0, 2.5",
                    "Walls/top/Position=0", "Time/Time step=1"});
  const double volume = model->solid_area();
  go(*model, 2.);
  std::cout << "grown: volume / expected " << model->solid_area() / (volume * std::exp(0.6)) << ", stored "
            << below(1e-6, model->energies().elastic) << ", brought in "
            << below(1e-5, column(*model, "growth_work_J")) << ", steps that the law cut "
            << column(*model, "law_cuts") << '\n';
}

void hit(const std::string &speed, const std::string &cfl_multiple)
{
  const std::string law = "Materials/gel/J2 plastic/";
  const Changes changes = {"Materials/gel/Law=j2_plastic",      law + "Young's modulus=1",
                           law + "Poisson's ratio=0.3",         law + "Yield stress=0.01",
                           "Time/CFL multiple=" + cfl_multiple, "Bodies/a/Center=0.1, -0.2, 2.5",
                           "Bodies/a/Velocity=0; 0; -" + speed};
  MovingBalls ball(text_of(1, true), changes), half(text_of(1, true), changes);
  const double before = ball.total_energy(), kinetic = ball.model->energies().kinetic,
               falls = ball.velocity(0)[2], end = 0.1 / std::stod(speed) + 40.;
  double momentum = 0.;
  ball.run(end, [&](const StepReport &)
           { momentum = std::max(momentum, std::abs(ball.model->momentum_error())); });
  half.run(end - 20., [](const StepReport &) {});
  MovingBalls rest(text_of(1, true), changes);
  take_state(*half.model, *rest.model);
  rest.run(end, [](const StepReport &) {});
  MovingBalls through(text_of(1, true), changes);
  through.run(end - 20., [](const StepReport &) {});
  through.run(end, [](const StepReport &) {});
  const bool same = rest.state().bodies[0].nodes.velocity == through.state().bodies[0].nodes.velocity &&
                    rest.model->energies().dissipated == through.model->energies().dissipated &&
                    rest.model->snapshot().points.stress == through.model->snapshot().points.stress;
  std::cout << "hits a wall at " << speed << ", steps of " << cfl_multiple << " CFL: comes back with "
            << -ball.velocity(0)[2] / falls << ", lost in the law " << ball.state().laws.loss / kinetic
            << ", momentum off by " << below(1e-12, momentum) << ", energy off by "
            << (ball.total_energy() - before) / kinetic << ", continued same " << same << '\n';
}
} // namespace

int main()
{
  relax();
  grow();
  hit("0.01", "4");
  hit("0.04", "4");
  hit("0.04", "2");
}
