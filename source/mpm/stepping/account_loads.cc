// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/account_loads.h>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
/// Power of @p acceleration of all nodes, which move at @p rate.
template <int dim>
double power(const Body<dim> &body, const dealii::Tensor<1, dim> &acceleration, const Eigen::VectorXd &rate)
{
  double sum = 0.;
  for (unsigned int i = 0; i < body.field.n_independent(); ++i)
    for (unsigned int d = 0; d < dim; ++d)
      sum += body.nodes.mass[i] * acceleration[d] * rate[dim * i + d];
  return sum;
}

/// Whether only the owner of a body can tell what one of its loads does apart from the others.
bool asks_owner(const Body<2> &body)
{
  return !body.rigid.driven && body.loads.size() > 1 &&
         std::any_of(body.loads.begin(), body.loads.end() - 1,
                     [](const auto &load) { return !load->is_uniform(); });
}

/// Powers of all loads but the last one, body by body.
std::vector<std::vector<double>> powers(const State &state, const BodyShare &share, const FoundStep &step)
{
  std::vector<std::vector<double>> of_bodies(state.bodies.size());
  const auto find = [&](const Body<2> &body)
  {
    of_bodies[body.index] =
        powers_of_loads(body, step.loads, step.increment[body.index], step.rate[body.index]);
  };
  if (!share.alone() && std::any_of(state.bodies.begin(), state.bodies.end(), asks_owner))
  {
    for (const Body<2> &body : state.bodies)
      of_bodies[body.index].resize(body.loads.empty() ? 0 : body.loads.size() - 1);
    share.for_mine(state.bodies, find,
                   [&](BodyShare::Message &message)
                   {
                     for (std::size_t b = 0; b < of_bodies.size(); ++b)
                       message.add(b, of_bodies[b].data(), of_bodies[b].size());
                   });
    return of_bodies;
  }
  for (const Body<2> &body : state.bodies)
    if (!body.rigid.driven && body.loads.size() > 1)
      find(body);
  return of_bodies;
}
} // namespace

template <int dim>
std::vector<double> powers_of_loads(const Body<dim> &body,
                                    const LoadTimes &times,
                                    const Eigen::VectorXd &increment,
                                    const Eigen::VectorXd &rate)
{
  std::vector<double> powers;
  for (auto load = body.loads.begin(); load + 1 < body.loads.end(); ++load)
    if ((*load)->is_uniform())
    {
      LoadPlace<dim> anywhere;
      anywhere.time = times.at;
      powers.push_back(power(body, (*load)->acceleration(anywhere), rate));
    }
    else
    {
      Eigen::VectorXd force = Eigen::VectorXd::Zero(rate.size());
      add_force(**load, body, times, &increment, force);
      powers.push_back(force.dot(rate));
    }
  return powers;
}

template std::vector<double>
powers_of_loads<2>(const Body<2> &, const LoadTimes &, const Eigen::VectorXd &, const Eigen::VectorXd &);
template std::vector<double>
powers_of_loads<3>(const Body<3> &, const LoadTimes &, const Eigen::VectorXd &, const Eigen::VectorXd &);

void account_loads(State &state, Workspace &work, const FoundStep &step)
{
  const double dt = step.plan.dt;
  const std::vector<std::vector<double>> known = powers(state, work.share, step);
  dealii::Tensor<1, 2> sum;
  work.load.assign(state.bodies.size(), sum);
  for (const Body<2> &body : state.bodies)
  {
    const Eigen::VectorXd &force = step.external[body.index];
    if (body.rigid.driven || force.size() == 0)
      continue;
    // The last load has what is left, so that the sum is that of all.
    double left = force.dot(step.rate[body.index]) * dt;
    auto load = body.loads.begin();
    for (const double power : known[body.index])
    {
      state.balance.load_work.add((*load++)->name, power * dt);
      left -= power * dt;
    }
    state.balance.load_work.add((*load)->name, left);
    for (unsigned int i = 0; i < body.field.n_independent(); ++i)
      for (unsigned int d = 0; d < 2; ++d)
        work.load[body.index][d] += force[2 * i + d];
    sum += work.load[body.index];
  }
  state.balance.momentum.of_loads += dt * sum;
}
} // namespace softgrain::mpm
