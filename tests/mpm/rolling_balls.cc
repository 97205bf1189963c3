// SPDX-License-Identifier: LGPL-2.1-or-later
// A ball that slides on a plane with friction begins to roll, at 5/7 of its velocity where it is rigid, and
// one rolls down a plane inclined by alpha with 5/7 g sin(alpha). Its lumped masses turn like a ball that is
// somewhat larger: with their rotary inertia I both are 1/(1 + I/(m R^2)), .689 in place of .714.
#include "moving_balls.h"

namespace
{
constexpr double gravity = 1e-4;

/// Mean velocity along the plane and velocity of the rim over it, in the second half of a run.
struct Rolling
{
  double velocity = 0., rim = 0., inertia = 0., energy = 0.;
  dealii::Tensor<1, 3> last;
};

/// @param unit of velocity at a time [m/s]
template <class Unit>
Rolling roll(const std::vector<std::string> &changes, const double end, const Unit &unit)
{
  MovingBalls ball(text_of(1, true), changes);
  const double before = ball.total_energy();
  Rolling rolling;
  ball.run(end,
           [&](const StepReport &report)
           {
             const Body<3> &body = ball.state().bodies[0];
             const double share = report.dt / (0.5 * end), v = ball.velocity(0)[0];
             double inertia = 0.;
             for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
             {
               const dealii::Tensor<1, 3> arm = body.field.place(i) +
                                                PlaceFunctions<3>::of_node(body.nodes.displacement, i) -
                                                body.center();
               inertia += body.nodes.mass[i] * (arm[0] * arm[0] + arm[2] * arm[2]);
             }
             rolling.inertia = inertia / (body.nodes.mass.sum() * radius * radius);
             if (ball.model->time() < 0.5 * end * (1. + 1e-9))
               return;
             rolling.velocity += share * v / unit(ball.model->time());
             rolling.rim += share * ball.spin(0)[1] / inertia * radius / v;
           });
  rolling.energy = (ball.total_energy() - before) / ball.model->energies().kinetic;
  rolling.last = ball.velocity(0) / ball.velocity(0)[0];
  return rolling;
}

std::string text(const double number)
{
  std::ostringstream out;
  out << number;
  return out.str();
}

void print(const std::string &what, const Rolling &rolling)
{
  std::cout << what << ": velocity " << rolling.velocity << ", rim over velocity " << rolling.rim
            << ", I/(m R^2) " << rolling.inertia << ", 1/(1 + I/(m R^2)) " << 1. / (1. + rolling.inertia)
            << ", aside " << below(0.03, rolling.last[1]) << ", energy " << below(3e-4, rolling.energy)
            << '\n';
}
} // namespace

int main()
{
  const std::vector<std::string> common = {"Bodies/a/Center=0.11, -0.07, 2.4", "Time/Time step=4"};
  const auto with = [&](std::vector<std::string> more)
  {
    more.insert(more.end(), common.begin(), common.end());
    return more;
  };
  const double v = std::sqrt(gravity * radius), angle = 0.3;
  print("slides and rolls, over the first velocity",
        roll(with({"Loads/Gravity=0, 0, -" + text(gravity), "Walls/bottom/Friction=0.3",
                   "Bodies/a/Velocity=" + text(v) + "; 0; 0"}),
             4. * 2. * v / (7. * 0.3 * gravity), [&](double) { return v; }));
  print("rolls down, over g sin(alpha) t",
        roll(with({"Loads/Gravity=" + text(gravity * std::sin(angle)) + ", 0, " +
                       text(-gravity * std::cos(angle)),
                   "Walls/bottom/Friction=0.5"}),
             4. * std::sqrt(radius / gravity),
             [&](const double t) { return gravity * std::sin(angle) * t; }));
}
