// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of StepEquations that knows how exact what is unbalanced can be.
#include <softgrain/mpm/stepping/step_equations.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace softgrain::mpm
{
template <int dim>
double summed_in_forces(const Body<dim> &body,
                        const StepState<dim> &trial,
                        const double cell_size,
                        const double contact,
                        const double internal,
                        const double dt)
{
  const unsigned int n = body.field.cells().nodes_per_cell();
  // A strain is a difference of numbers of order one, and of displacements over the size of a cell: that is
  // what stresses round by, times the modulus, whatever their own size.
  Eigen::VectorXd all = Eigen::VectorXd::Zero(dim * body.field.nodes().n()), own;
  for (unsigned int p = 0; p < body.points.size(); ++p)
  {
    const unsigned int *const nodes = body.field.at_point(p).nodes;
    const dealii::Tensor<1, dim> *const slope = body.field.at_point(p).slopes;
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int d = 0; d < dim; ++d)
        all[dim * nodes[k] + d] += trial.volume[p] * slope[k].norm();
  }
  body.field.extension().restrict(all, own);
  const double moved = body.nodes.displacement.template lpNorm<Eigen::Infinity>() / cell_size;
  return dt * body.material.law->wave_modulus() * (1. + moved) * own.norm() + contact + dt * internal;
}

template double summed_in_forces(const Body<2> &, const StepState<2> &, double, double, double, double);
template double summed_in_forces(const Body<3> &, const StepState<3> &, double, double, double, double);

double StepEquations::rounding(const Body<2> &body, const double contact) const
{
  const unsigned int b = body.index;
  double summed =
      summed_in_forces(body, work.trial[b], problem.settings.finest_cell(), contact, internal[b].norm(), dt);
  if (external[b].size() > 0)
    summed += dt * external[b].norm();
  summed += scheme_terms[b]->momentum_of_nodes(body).sum;
  return std::numeric_limits<double>::epsilon() * summed;
}

bool StepEquations::at_rounding() const
{
  const auto of_bodies = work.share.numbers<1>(state.bodies,
                                               [&](const Body<2> &body)
                                               {
                                                 Eigen::VectorXd contact =
                                                     Eigen::VectorXd::Zero(body.field.n_dofs());
                                                 work.contact.add_impulses(body.index, contact);
                                                 return std::array<double, 1>{rounding(body, contact.norm())};
                                               });
  for (const Body<2> &body : state.bodies)
    // What is not a number is not rounding.
    if (!body.rigid.driven && !(measured[body.index][1] <= of_bodies[body.index][0]))
      return false;
  return true;
}

std::string StepEquations::worst_body() const
{
  const Body<2> *worst = nullptr;
  for (const Body<2> &body : state.bodies)
    if (!body.rigid.driven && (worst == nullptr || !(measured[body.index][1] <= measured[worst->index][1])))
      worst = &body;
  std::ostringstream text;
  if (worst != nullptr)
    text << "body '" << worst->name << "' at (" << worst->center() << ") m";
  return text.str();
}
} // namespace softgrain::mpm
