// SPDX-License-Identifier: LGPL-2.1-or-later
// Walls under pressure that have a mass, in space. A wall that nothing bears yet, without damping, falls as
// its mass says: place, speed and energy are those of a fall. On a ball it swings, and what damps brings it
// to rest: then it bears its pressure times the area, as the floor does, and stands where a wall without
// inertia stands. Energy and momentum balance in between. The mirror image is the same, and a run that is
// continued, to the last bit. The usual mass is a tenth of that of the ball. Where there is no wall with a
// mass, parameters are refused.
#include "../continued.h"
#include "moving_balls.h"

#include <cmath>

namespace
{
const double area = 7. * 7.;

/// A ball of radius 2.4 on the floor of a box, below a top at @p height.
std::string box(const std::string &height)
{
  std::string text = text_of(1, false);
  const std::string sides = "subsection Walls\n  set Names = bottom, top, left, right, front, back\n"
                            "  subsection bottom\n    set Point = 0, 0, 0\n  end\n"
                            "  subsection top\n    set Point = 0, 0, " +
                            height +
                            "\n    set Drive = pressure\n    set Pressure = 0.005\n  end\n"
                            "  subsection left\n    set Point = -3.5, 0, 0\n  end\n"
                            "  subsection right\n    set Point = 3.5, 0, 0\n  end\n"
                            "  subsection front\n    set Point = 0, -3.5, 0\n  end\n"
                            "  subsection back\n    set Point = 0, 3.5, 0\n  end\nend\n";
  return text.insert(text.find("subsection Stop"), sides);
}

using Changes = std::vector<std::string>;

Changes with(Changes changes, const Changes &more)
{
  changes.insert(changes.end(), more.begin(), more.end());
  return changes;
}

const Changes at_floor = {"Bodies/a/Center=0.02, -0.03, 2.4"}, heavy = {"Walls/top/Mass=20"};

void fall()
{
  MovingBalls ball(box("30"), with(at_floor, {"Walls/top/Mass=20", "Walls/top/Damping=0", "Time/Theta=0.5"}));
  ball.run(10., [](const StepReport &) {});
  const WallState<3> top = ball.model->walls()[1];
  const double faster = 0.005 * area / 20., t = ball.model->time();
  const Energies energies = ball.model->energies();
  std::cout << "falls: place off by " << below(1e-9, (30. - top.position) / (0.5 * faster * t * t) - 1.)
            << ", speed by " << below(1e-9, top.velocity / (faster * t) - 1.) << ", energy by "
            << below(1e-9, energies.kinetic / energies.external_work - 1.) << ", work by "
            << below(1e-9, energies.external_work / (0.005 * area * (30. - top.position)) - 1.) << '\n';
}

void settle()
{
  // In the middle of a cell the ball does not turn; a grid that has turned gives way otherwise.
  const Changes no_dents = {"Bodies/a/Center=0, 0, 2.4", "Contact/Sub-grid compliance=false",
                            "Material points/Fill limit=0.95"};
  MovingBalls ball(box("4.85"), with(no_dents, {"Walls/top/Mass=20", "Time/Theta=1"}));
  double momentum = 0., lowest = 10.;
  ball.run(600.,
           [&](const StepReport &)
           {
             momentum = std::max(momentum, std::abs(ball.model->momentum_error()));
             lowest = std::min(lowest, ball.model->walls()[1].position);
           });
  MovingBalls still(box("4.85"),
                    with(no_dents, {"Time/Scheme=quasi_static", "Time/Time step=1", "Time/CFL multiple=0"}));
  StepReport report = still.model->advance(1.);
  still.model->settle(report);
  const std::vector<WallState<3>> walls = ball.model->walls();
  const double place = still.model->walls()[1].position, dent = 4.8 - place;
  std::cout << "rests: top over load off by " << below(1e-3, walls[1].normal_force / (0.005 * area) - 1.)
            << ", floor by " << below(1e-3, walls[0].normal_force / (0.005 * area) - 1.) << ", place by "
            << below(1e-3, (walls[1].position - place) / dent) << ", swung beyond it by "
            << (place - lowest) / dent << " of the dent, energy off by "
            << below(1e-3, ball.total_energy() / ball.model->energies().external_work) << ", momentum by "
            << below(1e-11, momentum) << ", kinetic energy left "
            << below(1e-6, ball.model->energies().kinetic) << '\n';
}

void compare()
{
  MovingBalls ball(box("5"), with(at_floor, heavy)),
      image(box("5"), with({"Bodies/a/Center=-0.02, -0.03, 2.4"}, heavy)),
      half(box("5"), with(at_floor, heavy)), rest(box("5"), with(at_floor, heavy)),
      usual(box("30"), with(at_floor, {"Walls/top/Damping=0"}));
  const auto nothing = [](const StepReport &) {};
  ball.run(25., nothing);
  ball.run(50., nothing);
  image.run(25., nothing);
  image.run(50., nothing);
  half.run(25., nothing);
  take_state(*half.model, *rest.model);
  rest.run(50., nothing);
  const WallState<3> top = ball.model->walls()[1], of_image = image.model->walls()[1],
                     continued = rest.model->walls()[1];
  std::cout << "mirror image: place off by " << below(1e-9, top.position - of_image.position) << ", force by "
            << below(1e-7, top.normal_force / of_image.normal_force - 1.) << "\ncontinued: same "
            << (top.position == continued.position && top.velocity == continued.velocity &&
                ball.model->energies().dissipated == rest.model->energies().dissipated &&
                ball.state().bodies[0].nodes.velocity == rest.state().bodies[0].nodes.velocity)
            << '\n';
  usual.run(5., nothing);
  const double mass = 0.1 * 4. / 3. * M_PI * std::pow(radius, 3);
  std::cout << "usual mass off by "
            << below(1e-9, 0.005 * area * usual.model->time() / usual.model->walls()[1].velocity / mass - 1.)
            << '\n';
}
} // namespace

int main()
{
  fall();
  settle();
  compare();
  refused(box("5"), with(at_floor, {"Time/Scheme=explicit"}));
  refused(box("5"), with(at_floor, {"Time/Scheme=quasi_static", "Time/Time step=1", "Time/CFL multiple=0",
                                    "Walls/top/Mass=3"}));
  refused(box("5"), with(at_floor, {"Walls/top/Mass=0"}));
  refused(box("5"), with(at_floor, {"Walls/bottom/Type=periodic", "Walls/top/Type=periodic"}));
}
