// SPDX-License-Identifier: LGPL-2.1-or-later
// The matrices of the equations of a step, and solves with them.
#include <softgrain/mpm/stepping/step_equations.h>
#include <softgrain/mpm/stepping/stiffness.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace softgrain::mpm
{
void StepEquations::resist_more(const double factor, const Vectors &v, const bool in_matrices)
{
  work.share.for_mine(state.bodies,
                      [&](const Body<2> &body)
                      {
                        const unsigned int b = body.index;
                        scheme_terms[b]->resist_more(body, factor, v[b], missing_impulse[b],
                                                     in_matrices ? &work.matrices[b] : nullptr);
                      });
}

void StepEquations::assemble_exact(const Body<2> &body)
{
  const unsigned int b = body.index;
  SystemMatrix &matrix = work.matrices[b];
  matrix.set_zero();
  add_stiffness(body, work.trial[b], scheme_terms[b]->stiffness_weight(), matrix);
  scheme_terms[b]->add_mass(body, matrix);
  if (body.loads.see_velocity())
    add_load_tangent(body, loads, increment[b], scheme.theta * dt, matrix);
  work.solvers[b]->set_update(scheme_terms[b]->held(), scheme_terms[b]->held_weight(body, work.trial[b]));
}

std::string StepEquations::factorise()
{
  constexpr unsigned int most_attempts = 7;
  constexpr double first_shift = 1e-2, rise = 10.; // of the mass matrix, over Young's modulus
  std::vector<double> more(state.bodies.size(), 0.), pending(state.bodies.size(), 1.); // numbers, to be told
  for (unsigned int attempt = 0;; ++attempt)
  {
    const auto assemble_mine = [&]()
    {
      dealii::TimerOutput::Scope section(*work.timer, "assembly");
      work.share.for_mine_here(state.bodies,
                               [&](const Body<2> &body)
                               {
                                 const unsigned int b = body.index;
                                 if (!pending[b])
                                   return;
                                 assemble_exact(body);
                                 work.matrices[b].add_mass<2>(body.nodes.mass, more[b]);
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
                                   more[b] = std::max(rise * more[b], first_shift * dt * dt *
                                                                          body.material.law->young_modulus() /
                                                                          body.nodes.mass.sum());
                               });
    };
    work.share.together(
        [&]()
        {
          assemble_mine();
          factorise_mine();
        },
        [&](BodyShare::Message &message) { message.add(pending); });
    const auto unstable =
        std::find_if(state.bodies.begin(), state.bodies.end(),
                     [&](const Body<2> &body) { return !body.rigid.driven && pending[body.index]; });
    if (unstable == state.bodies.end())
      return "";
    if (attempt == most_attempts)
      return "the stiffness of body '" + unstable->name +
             "' is not positive definite: it buckles or the step is too long ('Time/Time step')";
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
