// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/linear/system_matrix.h>
#include <softgrain/mpm/stepping/external_force.h>
#include <softgrain/scene/loads_over_step.h>

namespace softgrain::mpm
{
namespace
{
/// Adds @p acceleration of every node times its mass.
template <int dim, class Acceleration>
void add_at_nodes(const Body<dim> &body, const Acceleration &acceleration, Eigen::VectorXd &force)
{
  for (unsigned int i = 0; i < body.field.n_independent(); ++i)
  {
    const dealii::Tensor<1, dim> a = acceleration(i);
    for (unsigned int d = 0; d < dim; ++d)
      force[dim * i + d] += body.nodes.mass[i] * a[d];
  }
}

template <int dim>
void add_uniform(const Body<dim> &body, const dealii::Tensor<1, dim> &acceleration, Eigen::VectorXd &force)
{
  add_at_nodes(
      body, [&](unsigned int) { return acceleration; }, force);
}

/// Adds the sum of @p acceleration of all points, which is asked for where they are at the start of the step.
template <int dim, class Acceleration>
void add_at_points(const Body<dim> &body,
                   const double time,
                   const Acceleration &acceleration,
                   Eigen::VectorXd &force)
{
  const unsigned int n = body.field.cells().nodes_per_cell();
  Eigen::VectorXd all = Eigen::VectorXd::Zero(dim * body.field.nodes().n()), own, displacement;
  body.field.extension().prolongate(body.nodes.displacement, displacement);
  LoadPlace<dim> place;
  place.time = time;
  for (unsigned int p = 0; p < body.points.size(); ++p)
  {
    const unsigned int *nodes = body.field.at_point(p).nodes;
    const double *value = body.field.at_point(p).values;
    const auto point = body.points[p];
    for (unsigned int d = 0; d < dim; ++d)
    {
      place.now[d] = point.position()[d];
      for (unsigned int k = 0; k < n; ++k)
        place.now[d] += value[k] * displacement[dim * nodes[k] + d];
    }
    place.at_rest = body.rest.position[body.points.number(p)];
    const dealii::Tensor<1, dim> a = acceleration(place);
    for (unsigned int d = 0; d < dim; ++d)
    {
      const double b = point.mass() * a[d];
      for (unsigned int k = 0; k < n; ++k)
        all[dim * nodes[k] + d] += b * value[k];
    }
  }
  body.field.extension().restrict(all, own);
  force += own;
}

/// An independent node at the start of a step.
template <int dim>
LoadPlace<dim> node_at_start(const Body<dim> &body, const unsigned int i, const double time)
{
  LoadPlace<dim> place;
  place.now = body.field.place(i);
  place.time = time;
  for (unsigned int d = 0; d < dim; ++d)
  {
    place.now[d] += body.nodes.displacement[dim * i + d];
    place.velocity[d] = body.nodes.velocity[dim * i + d];
  }
  return place;
}

/// An independent node in the middle of a trial.
template <int dim>
LoadPlace<dim> node_halfway(const Body<dim> &body,
                            const unsigned int i,
                            const LoadTimes &times,
                            const Eigen::VectorXd &increment)
{
  LoadPlace<dim> place = node_at_start(body, i, times.begin + 0.5 * times.dt);
  for (unsigned int d = 0; d < dim; ++d)
  {
    place.now[d] += 0.5 * increment[dim * i + d];
    place.velocity[d] = increment[dim * i + d] / times.dt;
  }
  return place;
}
/// Adds the mean over the step of a load that sees the velocity, of which that of the start is known.
template <int dim>
void add_from_the_start(const Load<dim> &load,
                        const Body<dim> &body,
                        const LoadTimes &times,
                        Eigen::VectorXd &force)
{
  std::vector<const Load<dim> *> at_nodes;
  std::size_t which = 0;
  for (const auto &one : body.loads)
    if (!looks_at_points(*one))
    {
      if (one.get() == &load)
        which = at_nodes.size();
      at_nodes.push_back(one.get());
    }
  std::vector<dealii::Tensor<1, dim>> means;
  add_at_nodes(
      body,
      [&](const unsigned int i)
      {
        mean_accelerations(at_nodes, node_at_start(body, i, times.begin), times.dt, means);
        return means[which];
      },
      force);
}
} // namespace

template <int dim>
void add_force(const Load<dim> &load,
               const Body<dim> &body,
               const LoadTimes &times,
               const Eigen::VectorXd *const increment,
               Eigen::VectorXd &force)
{
  if (looks_at_points(load))
    add_at_points(
        body, times.at, [&](const LoadPlace<dim> &place) { return load.acceleration(place); }, force);
  else if (load.is_uniform())
  {
    LoadPlace<dim> anywhere;
    anywhere.time = times.at;
    add_uniform(body, load.acceleration(anywhere), force);
  }
  else if (times.from_the_start)
    add_from_the_start(load, body, times, force);
  else
    add_at_nodes(
        body,
        [&](const unsigned int i) { return load.acceleration(node_halfway(body, i, times, *increment)); },
        force);
}

template <int dim>
bool external_force(const Body<dim> &body, const LoadTimes &times, Eigen::VectorXd &force)
{
  force.setZero(body.field.n_dofs());
  if (body.loads.empty())
    return false;
  if (const dealii::Tensor<1, dim> everywhere = body.loads.uniform(times.at); everywhere.norm_square() > 0.)
    add_uniform(body, everywhere, force);
  if (body.loads.look_at_points())
    add_at_points(
        body, times.at,
        [&](const LoadPlace<dim> &place)
        {
          dealii::Tensor<1, dim> sum;
          for (const auto &load : body.loads)
            if (looks_at_points(*load))
              sum += load->acceleration(place);
          return sum;
        },
        force);
  if (times.from_the_start)
    for (const auto &load : body.loads)
      if (load->sees_velocity())
        add_force(*load, body, times, nullptr, force);
  return true;
}

template <int dim>
void add_forces_of_velocity(const Body<dim> &body,
                            const LoadTimes &times,
                            const Eigen::VectorXd &increment,
                            Eigen::VectorXd &force)
{
  for (const auto &load : body.loads)
    if (load->sees_velocity())
      add_force(*load, body, times, &increment, force);
}

template <int dim>
void add_load_tangent(const Body<dim> &body,
                      const LoadTimes &times,
                      const Eigen::VectorXd &increment,
                      const double factor,
                      SystemMatrix &matrix)
{
  for (const auto &load : body.loads)
    if (load->sees_velocity())
      for (unsigned int i = 0; i < body.field.n_independent(); ++i)
        matrix.add_node<dim>(i,
                             -factor * body.nodes.mass[i] *
                                 symmetrize(load->velocity_tangent(node_halfway(body, i, times, increment))));
}

template void
add_force<2>(const Load<2> &, const Body<2> &, const LoadTimes &, const Eigen::VectorXd *, Eigen::VectorXd &);
template void
add_force<3>(const Load<3> &, const Body<3> &, const LoadTimes &, const Eigen::VectorXd *, Eigen::VectorXd &);
template bool external_force<2>(const Body<2> &, const LoadTimes &, Eigen::VectorXd &);
template bool external_force<3>(const Body<3> &, const LoadTimes &, Eigen::VectorXd &);
template void
add_forces_of_velocity<2>(const Body<2> &, const LoadTimes &, const Eigen::VectorXd &, Eigen::VectorXd &);
template void
add_forces_of_velocity<3>(const Body<3> &, const LoadTimes &, const Eigen::VectorXd &, Eigen::VectorXd &);
template void
add_load_tangent<2>(const Body<2> &, const LoadTimes &, const Eigen::VectorXd &, double, SystemMatrix &);
template void
add_load_tangent<3>(const Body<3> &, const LoadTimes &, const Eigen::VectorXd &, double, SystemMatrix &);
} // namespace softgrain::mpm
