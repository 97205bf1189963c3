// SPDX-License-Identifier: LGPL-2.1-or-later
// The matrices of the equations of a step, and solves with them.
#include <softgrain/mpm/body/whole_rotation.h>
#include <softgrain/mpm/stepping/step_equations.h>
#include <softgrain/mpm/stepping/stiffness.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
constexpr double small_turn = 1e-3; ///< over half a step, which Newton's method need not know
} // namespace

void StepEquations::assemble(const Body<2> &body, const double shift_of_body, const bool pressure_follows)
{
  SystemMatrix &matrix = work.matrices[body.index];
  const double factor = scheme.theta * scheme.theta * dt * dt;
  matrix.set_zero();
  const double against_rotation = factor * rotation_stiffness(body, work.trial[body.index]);
  if (!pressure_follows)
    turns_easily[body.index] =
        scheme.inertia && against_rotation > 0.1 * rotary_inertia(body, rotation[body.index]);
  add_stiffness(body, work.trial[body.index], factor, matrix, pressure_follows);
  if (scheme.inertia)
    matrix.add_mass<2>(body.mass, 1. + shift_of_body);
  else
    matrix.add_mass<2>(drag(body), shift_of_body);
  work.solvers[body.index]->set_update(
      lever[body.index].size() > 0 ? lever[body.index] : rotation[body.index],
      (pressure_follows ? 0.2 : 1.) * against_rotation + rotation_weight[body.index]);
}

void StepEquations::resist_more(const double factor)
{
  for (double &of_body : shift)
    of_body *= factor;
}

void StepEquations::assemble_exact(const Body<2> &body)
{
  const unsigned int b = body.index;
  SystemMatrix &matrix = work.matrices[b];
  matrix.set_zero();
  add_stiffness(body, work.trial[b], scheme.theta * scheme.theta * dt * dt, matrix);
  if (scheme.inertia)
    matrix.add_mass<2>(body.mass, 1.);
  else
    matrix.add_mass<2>(drag(body), shift[b]);
  // What theta > 1/2 damps is no turn, see acting_force(). Its stiffness against a turn, -2 p A, is taken
  // back: left in, Newton's method diverges where grains roll in long steps.
  const double damped = scheme.inertia && scheme.theta > 0.5 ? (2. * scheme.theta - 1.) * scheme.theta * dt *
                                                                   dt * pressure_area(body, work.trial[b])
                                                             : 0.;
  work.solvers[b]->set_update(lever[b].size() > 0 ? lever[b] : rotation[b], rotation_weight[b] + damped);
}

std::string StepEquations::factorise()
{
  std::vector<double> extra = shift;
  std::vector<double> pending(state.bodies.size(), 1.); // numbers, for other ranks to know them
  for (unsigned int attempt = 0;; ++attempt)
  {
    // Under pressure many shapes of a body are unstable that its contacts hold, for they follow it.
    const bool pressure_follows = attempt > 0;
    const auto assemble_mine = [&]()
    {
      dealii::TimerOutput::Scope section(*work.timer, "assembly");
      work.share.for_mine_here(state.bodies,
                               [&](const Body<2> &body)
                               {
                                 if (pending[body.index])
                                   assemble(body, extra[body.index], pressure_follows);
                               });
    };
    const auto factorise_mine = [&]()
    {
      dealii::TimerOutput::Scope section(*work.timer, "factorisation");
      work.share.for_mine_here(state.bodies,
                               [&](const Body<2> &body)
                               {
                                 const unsigned int b = body.index;
                                 if (pending[b])
                                   pending[b] = !work.solvers[b]->factorize(work.matrices[b]);
                                 if (pending[b])
                                   if (attempt > 0)
                                     extra[b] =
                                         std::max(10. * extra[b], 1e-2 * dt * dt * body.law->young_modulus() /
                                                                      body.mass.sum());
                               });
    };
    work.share.together(
        [&]()
        {
          assemble_mine();
          factorise_mine();
        },
        [&](BodyShare::Message &message)
        {
          message.add(pending);
          message.add(turns_easily);
        });
    bool done = true;
    for (const Body<2> &body : state.bodies)
      if (moves(body.index) && pending[body.index])
      {
        done = false;
        if (attempt == 7)
          return "the stiffness of body '" + body.name +
                 "' is not positive definite: it buckles or the step is too long ('Time/Time step')";
      }
    has_followed = has_followed || attempt > 0;
    if (done)
      return "";
  }
}

void StepEquations::heed_turn(const Body<2> &body, const Eigen::VectorXd &b, Eigen::VectorXd &x) const
{
  const unsigned int n = body.index;
  const double half = half_turn[n], quarter = dealii::numbers::PI_2;
  // By how much the missing impulse changes with the turn, per radian.
  const Eigen::VectorXd by_turn = dt * ((1. - scheme.theta) * turned(old_force[n], quarter + half) -
                                        scheme.theta * turned(internal[n], quarter - half));
  Eigen::VectorXd missing = b, more = x;
  for (unsigned int correction = 0; correction < 2; ++correction)
  {
    // A x less the part of the masses comes from forces.
    for (unsigned int i = 0; i < body.mass.size(); ++i)
      missing.segment<2>(2 * i) -= body.mass[i] * more.segment<2>(2 * i);
    const Eigen::VectorXd of_forces = turned(missing, -half);
    missing += 0.5 * scheme.theta * dt * rotation[n].dot(more) * by_turn - of_forces;
    work.solvers[n]->solve(missing, more);
    x += more;
  }
}

void StepEquations::solve_free(const unsigned int b, Eigen::VectorXd &x) const
{
  work.solvers[b]->solve(missing_impulse[b], x);
}

StepEquations::Slope StepEquations::solve(const bool with_contact, Vectors &x) const
{
  dealii::TimerOutput::Scope section(*work.timer, "linear solves");
  const auto of_bodies = work.share.numbers<3>(
      state.bodies,
      [&](const Body<2> &body)
      {
        const unsigned int b = body.index;
        const Eigen::VectorXd right = with_contact ? unbalanced(b) : missing_impulse[b];
        work.solvers[b]->solve(right, x[b]);
        if (!with_contact && work.contact.empty() && std::abs(half_turn[b]) > small_turn)
          heed_turn(body, missing_impulse[b], x[b]);
        return std::array<double, 3>{x[b].dot(right), right.squaredNorm(), x[b].squaredNorm()};
      });
  Slope slope;
  for (const auto &[work_done, square, length_square] : of_bodies)
  {
    slope.work += work_done;
    slope.merit += square;
    slope.length += length_square;
  }
  slope.merit = std::sqrt(slope.merit);
  slope.length = std::sqrt(slope.length);
  return slope;
}
} // namespace softgrain::mpm
