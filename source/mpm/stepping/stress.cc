// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/constitutive/refusal.h>
#include <softgrain/mpm/field/cell_slopes.h>
#include <softgrain/mpm/stepping/cell_gradients.h>
#include <softgrain/mpm/stepping/stress.h>

#include <atomic>
#include <cmath>
#include <optional>
#include <sstream>

namespace softgrain::mpm
{
namespace
{
constexpr std::size_t cell_grain = 32;

template <int dim>
dealii::Tensor<2, dim> identity()
{
  dealii::Tensor<2, dim> one;
  for (unsigned int d = 0; d < dim; ++d)
    one[d][d] = 1.;
  return one;
}

/// What to compute besides the stress.
struct Wishes
{
  Trial trial;
  bool measures = false; ///< energy, out-of-plane stress and, of laws of small strain, averaged gradients
};

/// Sizes a step state for the body's points; cheap when nothing changed.
template <int dim>
void resize(const Body<dim> &body, const Wishes &wishes, StepState<dim> &s)
{
  const std::size_t n = body.points.size();
  s.grid_gradient.resize(n);
  s.gradient.resize(n);
  s.volume.resize(n);
  s.stress.resize(n);
  if (body.material.small_strain() || body.material.law->n_history() > 0 || wishes.trial.max_strain > 0.)
    s.increment.resize(n);
  if (wishes.trial.tangent)
    s.tangent.resize(n);
  if (wishes.measures)
  {
    s.energy.resize(n);
    s.out_of_plane_stress.resize(n);
  }
  if (body.material.law->n_history() > 0)
  {
    s.dissipation.resize(n);
    s.supply.assign(body.material.law->is_active() ? n : 0, 0.);
    s.history_old.resize(n * body.material.law->n_history());
    s.history.resize(n * body.material.law->n_history());
  }
}

/// F = (I + grad U) F_grid at the points of one cell, and what the law needs beside it.
template <int dim>
void deform_cell(const Body<dim> &body,
                 const unsigned int cell,
                 const double half_dt,
                 const Eigen::VectorXd &nodal_velocity,
                 StepState<dim> &s)
{
  const bool small = body.material.small_strain();
  const unsigned int n_history = body.material.law->n_history();
  const CellGradients<dim> gradients(body.field, cell, s.nodal,
                                     s.increment.empty() ? nullptr : &s.nodal_increment);
  std::optional<CellGradients<dim>> rates;
  if (small && half_dt > 0. && body.nodes.velocity.size() > 0)
    rates.emplace(body.field, cell, nodal_velocity, nullptr);
  for (unsigned int p = body.field.cells().first_point(cell); p < body.field.cells().first_point(cell + 1);
       ++p)
  {
    const auto [gradient, increment] = gradients(p);
    s.grid_gradient[p] = identity<dim>() + gradient;
    const auto point = body.points[p];
    s.gradient[p] = s.grid_gradient[p] * point.gradient();
    s.volume[p] = small ? point.volume() : point.rest_volume();
    if (n_history > 0)
      std::copy_n(point.history(), n_history, &s.history_old[p * n_history]);
    if (s.increment.empty())
      continue;
    if (small)
    {
      s.increment[p] = increment;
      if (half_dt > 0.)
      {
        // (3.17): trapezoidal rule for the conservation of mass.
        const double old_part = rates ? 1. + half_dt * trace((*rates)(p).first) : 1.;
        s.volume[p] *= old_part / (old_part - trace(increment));
      }
    }
    else
    {
      // From the start of the step: (I + grad U)(I + grad U_old)^-1 - I.
      s.increment[p] = s.grid_gradient[p] * invert(s.grid_gradient[p] - increment) - identity<dim>();
    }
  }
}

/// Mean of @p value over the points of one cell, weighted with the volume that multiplies the stress.
template <int dim, typename Value>
double
mean_of_cell(const StepState<dim> &s, const unsigned int begin, const unsigned int end, const Value &value)
{
  double sum = 0., weight = 0.;
  for (unsigned int p = begin; p < end; ++p)
  {
    sum += s.volume[p] * value(p);
    weight += s.volume[p];
  }
  return sum / weight;
}

/// Replaces a share of the dilatation in F at the points of one cell by its mean over the cell (F-bar, de
/// Souza Neto et al. 1996).
template <int dim>
void average_gradients(const Body<dim> &body, const unsigned int cell, StepState<dim> &s)
{
  const unsigned int begin = body.field.cells().first_point(cell),
                     end = body.field.cells().first_point(cell + 1);
  const double mean =
      mean_of_cell(s, begin, end, [&](const unsigned int p) { return determinant(s.gradient[p]); });
  for (unsigned int p = begin; p < end; ++p)
    if (determinant(s.gradient[p]) > 0. && mean > 0.)
      s.gradient[p] *= std::pow(mean / determinant(s.gradient[p]), body.material.averaged / dim);
}

/// The same for laws of small strain, which get the strain over the step.
template <int dim>
void average_increments(const Body<dim> &body, const unsigned int cell, StepState<dim> &s)
{
  const unsigned int begin = body.field.cells().first_point(cell),
                     end = body.field.cells().first_point(cell + 1);
  const double mean =
      mean_of_cell(s, begin, end, [&](const unsigned int p) { return trace(s.increment[p]); });
  for (unsigned int p = begin; p < end; ++p)
    s.increment[p] += body.material.averaged * (mean - trace(s.increment[p])) / dim * identity<dim>();
}

/// What averaging leaves of the deformation of the points of one cell, as far as anybody asks for it.
template <int dim>
void average_dilatation(const Body<dim> &body,
                        const unsigned int cell,
                        const bool measures,
                        StepState<dim> &s)
{
  if (body.material.small_strain())
    average_increments(body, cell, s);
  if (!body.material.small_strain() || measures)
    average_gradients(body, cell, s);
}

/// Whether the strain of any of these points over the step, f^T f - I with the deformation f over the step,
/// is above twice @p limit; @return the first such point or @p end.
template <int dim>
std::size_t leaps(const StepState<dim> &s, const std::size_t begin, const std::size_t end, const double limit)
{
  for (std::size_t p = begin; p < end; ++p)
  {
    const dealii::Tensor<2, dim> f = identity<dim>() + s.increment[p];
    if (!((transpose(f) * f - identity<dim>()).norm_square() <= 4. * limit * limit))
      return p;
  }
  return end;
}

/// What the law gets for @p n points from @p first on.
template <int dim>
constitutive::Inputs<dim> inputs_of(const Body<dim> &body,
                                    const StepState<dim> &s,
                                    const Trial &trial,
                                    const std::size_t first,
                                    const std::size_t n)
{
  constitutive::Inputs<dim> in;
  in.n_points = n;
  in.deformation_gradient = &s.gradient[first];
  in.increment = s.increment.empty() ? nullptr : &s.increment[first];
  in.history_old = s.history_old.empty() ? nullptr : &s.history_old[first * body.material.law->n_history()];
  in.dt = trial.dt;
  in.time = trial.time;
  return in;
}

/// Where the law puts what is wished, for the points from @p first on.
template <int dim>
constitutive::Outputs<dim>
outputs_of(const Body<dim> &body, const Wishes &wishes, const std::size_t first, StepState<dim> &s)
{
  const unsigned int n_history = body.material.law->n_history();
  constitutive::Outputs<dim> out;
  out.stress = &s.stress[first];
  if (wishes.trial.tangent)
    out.tangent = &s.tangent[first];
  if (wishes.measures)
  {
    out.energy = &s.energy[first];
    out.out_of_plane_stress = &s.out_of_plane_stress[first];
  }
  if (n_history > 0)
  {
    out.history_new = &s.history[first * n_history];
    out.dissipation = &s.dissipation[first];
    out.supply = s.supply.empty() ? nullptr : &s.supply[first];
  }
  return out;
}

/// Lowers @p least to @p value where that is less, whatever other threads do.
template <typename Number>
void lower(std::atomic<Number> &least, const Number value)
{
  for (Number known = least.load(); value < known && !least.compare_exchange_weak(known, value);)
    ;
}

/// What came out, where @p bad_point is the first point that is refused.
template <int dim>
StressOutcome outcome_of(const Body<dim> &body,
                         const StepState<dim> &s,
                         const Trial &trial,
                         const std::size_t bad_point,
                         const double share)
{
  StressOutcome outcome;
  outcome.bad_point = bad_point;
  outcome.share = share;
  if (outcome.good())
    return outcome;
  if (const auto *law = dynamic_cast<const constitutive::Refusal<dim> *>(body.material.law.get()))
    outcome.refusal = law->why_refused(inputs_of(body, s, trial, bad_point, 1));
  std::ostringstream place;
  place << body.points[bad_point].position();
  outcome.place = place.str();
  outcome.leaps = determinant(s.gradient[bad_point]) > 0.;
  return outcome;
}

template <int dim>
StressOutcome evaluate(const Body<dim> &body,
                       const Eigen::VectorXd &displacement,
                       const Eigen::VectorXd &increment,
                       const Wishes &wishes,
                       StepState<dim> &s)
{
  const double half_dt = wishes.trial.half_dt;
  resize(body, wishes, s);
  body.field.extension().prolongate(displacement, s.nodal);
  Eigen::VectorXd nodal_velocity;
  if (!s.increment.empty())
    body.field.extension().prolongate(increment, s.nodal_increment);
  if (half_dt > 0. && body.material.small_strain() && body.nodes.velocity.size() > 0)
    body.field.extension().prolongate(body.nodes.velocity, nodal_velocity);

  const bool limits_step = wishes.trial.dt > 0. && body.material.law->limits_step();
  // The smallest index, so that the message does not depend on the number of threads.
  std::atomic<std::size_t> bad{StressOutcome::none};
  std::atomic<double> share{1.};
  const auto work = [&](const std::size_t begin, const std::size_t end)
  {
    for (std::size_t c = begin; c < end; ++c)
    {
      deform_cell(body, c, half_dt, nodal_velocity, s);
      if (body.material.averaged > 0. &&
          body.field.cells().first_point(c) < body.field.cells().first_point(c + 1))
        average_dilatation(body, c, wishes.measures, s);
    }
    const std::size_t first = body.field.cells().first_point(begin),
                      n = body.field.cells().first_point(end) - first;
    if (n == 0)
      return;
    double allowed = 1.;
    constitutive::Outputs<dim> out = outputs_of(body, wishes, first, s);
    if (limits_step)
      out.step_share = &allowed;
    std::size_t good = body.material.law->update(inputs_of(body, s, wishes.trial, first, n), out);
    lower(share, allowed);
    if (good == n && wishes.trial.max_strain > 0.)
      good = leaps(s, first, first + n, wishes.trial.max_strain) - first;
    if (good < n)
      lower(bad, first + good);
  };
  parallel_for(body.field.cells().n(), cell_grain, work);
  return outcome_of(body, s, wishes.trial, bad.load(), share.load());
}
} // namespace

template <int dim>
StressOutcome evaluate_stress(const Body<dim> &body,
                              const Eigen::VectorXd &displacement,
                              const Eigen::VectorXd &increment,
                              const Trial &trial,
                              StepState<dim> &s)
{
  return evaluate(body, displacement, increment, {trial, false}, s);
}

template <int dim>
PointMeasures<dim>
measure_points(const Body<dim> &body, const Eigen::VectorXd &displacement, const Eigen::VectorXd &increment)
{
  StepState<dim> s;
  PointMeasures<dim> measures;
  evaluate(body, displacement, increment, {Trial(), true}, s);
  for (unsigned int p = 0; p < body.points.size(); ++p)
    measures.energy += s.energy[p] * s.volume[p];
  measures.out_of_plane_stress = std::move(s.out_of_plane_stress);
  measures.gradient = std::move(s.gradient);
  return measures;
}

template <int dim>
void internal_force(const Body<dim> &body, StepState<dim> &s, Eigen::VectorXd &force)
{
  const unsigned int n = body.field.cells().nodes_per_cell();
  s.of_cells.assign(body.field.cells().n() * n * dim, 0.);
  parallel_for(body.field.cells().n(), cell_grain,
               [&](const std::size_t begin, const std::size_t end)
               {
                 CellSlopes<dim> mean;
                 for (std::size_t c = begin; c < end; ++c)
                 {
                   double *f = &s.of_cells[c * n * dim];
                   double pressure = 0.;
                   for (unsigned int p = body.field.cells().first_point(c);
                        p < body.field.cells().first_point(c + 1); ++p)
                   {
                     auto stress = s.stress[p];
                     if (body.material.averaged > 0.)
                     {
                       const double mean_stress = body.material.averaged * trace(stress) / dim;
                       pressure += s.volume[p] * mean_stress;
                       for (unsigned int d = 0; d < dim; ++d)
                         stress[d][d] -= mean_stress;
                     }
                     // -V tau G^-T, so that every node costs one product with its slope.
                     dealii::Tensor<2, dim> q = -s.volume[p] * dealii::Tensor<2, dim>(stress);
                     if (!body.material.small_strain())
                       q = q * transpose(invert(s.grid_gradient[p]));
                     const dealii::Tensor<1, dim> *slope = body.field.at_point(p).slopes;
                     for (unsigned int k = 0; k < n; ++k)
                       for (unsigned int d = 0; d < dim; ++d)
                         f[dim * k + d] += q[d] * slope[k];
                   }
                   if (body.material.averaged > 0. &&
                       body.field.cells().first_point(c) < body.field.cells().first_point(c + 1))
                   {
                     mean_slopes(body, s, c, mean);
                     for (unsigned int k = 0; k < n; ++k)
                       for (unsigned int d = 0; d < dim; ++d)
                         f[dim * k + d] -= pressure * mean[k][d];
                   }
                 }
               });
  body.field.cells().gather(s.of_cells, s.nodal_increment);
  body.field.extension().restrict(s.nodal_increment, force);
}

#define INSTANTIATE(dim)                                                                                     \
  template StressOutcome evaluate_stress<dim>(const Body<dim> &, const Eigen::VectorXd &,                    \
                                              const Eigen::VectorXd &, const Trial &, StepState<dim> &);     \
  template PointMeasures<dim> measure_points<dim>(const Body<dim> &, const Eigen::VectorXd &,                \
                                                  const Eigen::VectorXd &);                                  \
  template void internal_force<dim>(const Body<dim> &, StepState<dim> &, Eigen::VectorXd &);
INSTANTIATE(2)
INSTANTIATE(3)
} // namespace softgrain::mpm
