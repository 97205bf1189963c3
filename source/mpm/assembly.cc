// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/assembly.h>
#include <softgrain/mpm/system_matrix.h>

#include <atomic>
#include <cmath>

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

/// Adds the gradient of a nodal vector at point @p p to @p gradient.
template <int dim>
void add_gradient(const BodyField<dim> &field,
                  const unsigned int p,
                  const unsigned int *nodes,
                  const Eigen::VectorXd &nodal,
                  dealii::Tensor<2, dim> &gradient)
{
  const dealii::Tensor<1, dim> *slope = field.slopes(p);
  for (unsigned int k = 0; k < field.nodes_per_cell(); ++k)
    for (unsigned int d = 0; d < dim; ++d)
    {
      const double u = nodal[dim * nodes[k] + d];
      for (unsigned int e = 0; e < dim; ++e)
        gradient[d][e] += u * slope[k][e];
    }
}

/// Sizes the step state for the body's points; cheap when nothing changed.
template <int dim>
void resize(Body<dim> &body, const StressWishes &wishes)
{
  const std::size_t n = body.points.size();
  StepState<dim> &s = body.step;
  s.grid_gradient.resize(n);
  s.gradient.resize(n);
  s.volume.resize(n);
  s.stress.resize(n);
  if (body.small_strain() || body.law->n_history() > 0)
    s.increment.resize(n);
  if (wishes.tangent)
    s.tangent.resize(n);
  if (wishes.energy)
  {
    s.energy.resize(n);
    s.dissipation.resize(n);
    s.out_of_plane_stress.resize(n);
  }
  s.history_old.resize(n * body.law->n_history());
  s.history.resize(n * body.law->n_history());
}

/// F = (I + grad U) F_grid at the points of one cell, and what the law needs beside it.
template <int dim>
void deform_cell(Body<dim> &body,
                 const unsigned int cell,
                 const double half_dt,
                 const Eigen::VectorXd &nodal_velocity)
{
  StepState<dim> &s = body.step;
  const unsigned int *nodes = body.field.nodes_of_cell(cell);
  const bool small = body.small_strain();
  const unsigned int n_history = body.law->n_history();
  for (unsigned int p = body.field.first_point(cell); p < body.field.first_point(cell + 1); ++p)
  {
    s.grid_gradient[p] = identity<dim>();
    add_gradient(body.field, p, nodes, s.nodal, s.grid_gradient[p]);
    const auto point = body.points[p];
    s.gradient[p] = s.grid_gradient[p] * point.gradient();
    s.volume[p] = small ? point.volume() : point.rest_volume();
    if (n_history > 0)
      std::copy_n(point.history(), n_history, &s.history_old[p * n_history]);
    if (s.increment.empty())
      continue;
    dealii::Tensor<2, dim> increment;
    add_gradient(body.field, p, nodes, s.nodal_increment, increment);
    if (small)
    {
      s.increment[p] = increment;
      if (half_dt > 0.)
      {
        // (3.17): trapezoidal rule for the conservation of mass.
        dealii::Tensor<2, dim> rate;
        add_gradient(body.field, p, nodes, nodal_velocity, rate);
        const double old_part = 1. + half_dt * trace(rate);
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

/// Replaces the dilatation at the points of one cell by its mean over the cell (F-bar, de Souza Neto et al.
/// 1996).
template <int dim>
void average_dilatation(Body<dim> &body, const unsigned int cell)
{
  StepState<dim> &s = body.step;
  const unsigned int begin = body.field.first_point(cell), end = body.field.first_point(cell + 1);
  double sum = 0., weight = 0.;
  for (unsigned int p = begin; p < end; ++p)
  {
    sum += s.volume[p] * (body.small_strain() ? trace(s.increment[p]) : determinant(s.gradient[p]));
    weight += s.volume[p];
  }
  const double mean = sum / weight;
  for (unsigned int p = begin; p < end; ++p)
    if (body.small_strain())
      s.increment[p] += (mean - trace(s.increment[p])) / dim * identity<dim>();
    else if (determinant(s.gradient[p]) > 0. && mean > 0.)
      s.gradient[p] *= std::pow(mean / determinant(s.gradient[p]), 1. / dim);
}

/// Slopes in the trial configuration at point @p p; small-strain laws stay with those of the grid.
template <int dim>
void current_slopes(const Body<dim> &body, const unsigned int p, std::vector<dealii::Tensor<1, dim>> &slopes)
{
  const dealii::Tensor<1, dim> *slope = body.field.slopes(p);
  slopes.resize(body.field.nodes_per_cell());
  if (body.small_strain())
    std::copy(slope, slope + slopes.size(), slopes.begin());
  else
  {
    const dealii::Tensor<2, dim> inverse = invert(body.step.grid_gradient[p]);
    for (unsigned int k = 0; k < slopes.size(); ++k)
      slopes[k] = slope[k] * inverse;
  }
}

/// Mean over a cell of the current slopes, weighted with current volume, and that volume: F-bar's dilatation.
template <int dim>
double mean_slopes(const Body<dim> &body, const unsigned int cell, std::vector<dealii::Tensor<1, dim>> &mean)
{
  mean.assign(body.field.nodes_per_cell(), dealii::Tensor<1, dim>());
  std::vector<dealii::Tensor<1, dim>> slopes;
  double total = 0.;
  for (unsigned int p = body.field.first_point(cell); p < body.field.first_point(cell + 1); ++p)
  {
    current_slopes(body, p, slopes);
    const auto point = body.points[p];
    // F holds the mean dilatation here, so the weight needs the determinant of what really happened.
    const double weight =
        body.small_strain()
            ? body.step.volume[p]
            : point.rest_volume() * determinant(body.step.grid_gradient[p]) * determinant(point.gradient());
    total += weight;
    for (unsigned int k = 0; k < mean.size(); ++k)
      mean[k] += weight * slopes[k];
  }
  for (auto &slope : mean)
    slope /= total;
  return total;
}

/// sym(a (x) slope) for a displacement of one node along direction @p d.
template <int dim>
dealii::SymmetricTensor<2, dim> strain_of(const dealii::Tensor<1, dim> &slope, const unsigned int d)
{
  dealii::SymmetricTensor<2, dim> strain;
  for (unsigned int e = 0; e < dim; ++e)
    strain[d][e] += (d == e ? 1. : 0.5) * slope[e];
  return strain;
}

/// Terms of the tangent that come from averaging the dilatation; see doc/theory.md, "F-bar".
template <int dim>
void add_dilatation_terms(const Body<dim> &body,
                          const unsigned int cell,
                          const std::vector<dealii::Tensor<1, dim>> &mean,
                          const double total,
                          Eigen::MatrixXd &local)
{
  const unsigned int n = mean.size();
  std::vector<dealii::Tensor<1, dim>> slopes;
  double pressure_sum = 0.;
  for (unsigned int p = body.field.first_point(cell); p < body.field.first_point(cell + 1); ++p)
    pressure_sum += body.step.volume[p] * trace(body.step.stress[p]) / dim;
  const auto add = [&](const unsigned int i, const unsigned int d, const unsigned int j, const unsigned int e,
                       const double value) { local(dim * i + d, dim * j + e) += value; };
  for (unsigned int p = body.field.first_point(cell); p < body.field.first_point(cell + 1); ++p)
  {
    current_slopes(body, p, slopes);
    const auto &tau = body.step.stress[p];
    const double v = body.step.volume[p], mean_tau = trace(tau) / dim;
    const auto point = body.points[p];
    const double weight =
        point.rest_volume() * determinant(body.step.grid_gradient[p]) * determinant(point.gradient()) / total;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int e = 0; e < dim; ++e)
          {
            const double si = (mean[i][d] - slopes[i][d]) / dim, sj = (mean[j][e] - slopes[j][e]) / dim;
            const double ti = dealii::Tensor<1, dim>(tau * slopes[i])[d],
                         tj = dealii::Tensor<1, dim>(tau * slopes[j])[e];
            const double cross = slopes[i][e] * slopes[j][d];
            add(i, d, j, e,
                v * (2. * (ti * sj + si * tj) + 2. * dim * si * sj * mean_tau + mean_tau * cross));
            add(i, d, j, e, pressure_sum * weight * (slopes[i][d] * slopes[j][e] - cross));
          }
  }
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = 0; e < dim; ++e)
          add(i, d, j, e, -pressure_sum * mean[i][d] * mean[j][e]);
}

/// Makes up for the negative stiffness that compression gives to rotation: -tr(tau)/2 W:W, W the skew part of
/// grad u.
template <int dim>
void add_rotation_guard(const std::vector<dealii::Tensor<1, dim>> &slopes,
                        const double weight,
                        Eigen::MatrixXd &local)
{
  // For u = e_d N: W = (e_d (x) g - g (x) e_d) / 2, so W_i:W_j = (g_i.g_j delta_de - g_i[e] g_j[d]) / 2.
  for (unsigned int i = 0; i < slopes.size(); ++i)
    for (unsigned int j = 0; j < slopes.size(); ++j)
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = 0; e < dim; ++e)
          local(dim * i + d, dim * j + e) +=
              0.25 * weight * ((d == e ? slopes[i] * slopes[j] : 0.) - slopes[i][e] * slopes[j][d]);
}

/// Stiffness of one cell over its own nodes.
template <int dim>
void cell_stiffness(const Body<dim> &body,
                    const unsigned int cell,
                    const bool guard_rotation,
                    Eigen::MatrixXd &local)
{
  constexpr unsigned int n_strain = dealii::SymmetricTensor<2, dim>::n_independent_components;
  const unsigned int n = body.field.nodes_per_cell();
  std::vector<dealii::Tensor<1, dim>> slopes, mean;
  Eigen::Matrix<double, n_strain, Eigen::Dynamic> B(n_strain, dim * n), CB(n_strain, dim * n);
  Eigen::Matrix<double, n_strain, n_strain> C;
  local.setZero(dim * n, dim * n);
  double total = 0.;
  if (body.f_bar)
    total = mean_slopes(body, cell, mean);
  for (unsigned int p = body.field.first_point(cell); p < body.field.first_point(cell + 1); ++p)
  {
    const double v = body.step.volume[p];
    current_slopes(body, p, slopes);
    for (unsigned int a = 0; a < n_strain; ++a)
      for (unsigned int b = 0; b < n_strain; ++b)
        C(a, b) = v * body.step.tangent[p].access_raw_entry(a * n_strain + b);
    for (unsigned int k = 0; k < n; ++k)
      for (unsigned int d = 0; d < dim; ++d)
      {
        auto strain = strain_of(slopes[k], d);
        if (body.f_bar)
          for (unsigned int e = 0; e < dim; ++e)
            strain[e][e] += (mean[k][d] - slopes[k][d]) / dim;
        for (unsigned int a = 0; a < n_strain; ++a)
          // Shear counts twice in the double contraction.
          B(a, dim * k + d) = (a < dim ? 1. : 2.) * strain.access_raw_entry(a);
      }
    CB.noalias() = C * B;
    local.noalias() += B.transpose() * CB;
    const auto &tau = body.step.stress[p];
    if (!body.small_strain())
      for (unsigned int j = 0; j < n; ++j)
      {
        const dealii::Tensor<1, dim> t = v * (tau * slopes[j]);
        for (unsigned int i = 0; i < n; ++i)
        {
          const double g = slopes[i] * t;
          for (unsigned int d = 0; d < dim; ++d)
            local(dim * i + d, dim * j + d) += g;
        }
      }
    // A little more than rigid rotation needs.
    if (guard_rotation && trace(tau) < 0.)
      add_rotation_guard(slopes, -1.25 * v * trace(tau), local);
  }
  if (body.f_bar && !body.small_strain())
    add_dilatation_terms(body, cell, mean, total, local);
}
} // namespace

template <int dim>
StressOutcome evaluate_stress(Body<dim> &body,
                              const Eigen::VectorXd &displacement,
                              const Eigen::VectorXd &increment,
                              const double half_dt,
                              const StressWishes &wishes)
{
  StepState<dim> &s = body.step;
  resize(body, wishes);
  body.field.prolongate(displacement, s.nodal);
  Eigen::VectorXd nodal_velocity;
  if (!s.increment.empty())
    body.field.prolongate(increment, s.nodal_increment);
  if (half_dt > 0. && body.small_strain())
    body.field.prolongate(body.velocity, nodal_velocity);

  const unsigned int n_history = body.law->n_history();
  std::atomic<std::size_t> bad{StressOutcome::none};
  parallel_for(body.field.n_cells(), cell_grain,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t c = begin; c < end; ++c)
                 {
                   deform_cell(body, c, half_dt, nodal_velocity);
                   if (body.f_bar && body.field.first_point(c) < body.field.first_point(c + 1))
                     average_dilatation(body, c);
                 }
                 const std::size_t first = body.field.first_point(begin),
                                   n = body.field.first_point(end) - first;
                 if (n == 0)
                   return;
                 constitutive::Inputs<dim> in;
                 in.n_points = n;
                 in.deformation_gradient = &s.gradient[first];
                 in.increment = s.increment.empty() ? nullptr : &s.increment[first];
                 in.history_old = n_history > 0 ? &s.history_old[first * n_history] : nullptr;
                 constitutive::Outputs<dim> out;
                 out.stress = &s.stress[first];
                 if (wishes.tangent)
                   out.tangent = &s.tangent[first];
                 if (wishes.energy)
                 {
                   out.energy = &s.energy[first];
                   out.dissipation = &s.dissipation[first];
                   out.out_of_plane_stress = &s.out_of_plane_stress[first];
                 }
                 // The history is cheap and some laws need a place for it whatever is asked.
                 out.history_new = n_history > 0 ? &s.history[first * n_history] : nullptr;
                 const std::size_t good = body.law->update(in, out);
                 if (good < n)
                 {
                   // The smallest index, so that the message does not depend on the number of threads.
                   std::size_t expected = bad.load();
                   while (first + good < expected && !bad.compare_exchange_weak(expected, first + good))
                     ;
                 }
               });
  StressOutcome outcome;
  outcome.bad_point = bad.load();
  return outcome;
}

template <int dim>
void internal_force(Body<dim> &body, Eigen::VectorXd &force)
{
  StepState<dim> &s = body.step;
  const unsigned int n = body.field.nodes_per_cell();
  s.of_cells.assign(body.field.n_cells() * n * dim, 0.);
  parallel_for(body.field.n_cells(), cell_grain,
               [&](const std::size_t begin, const std::size_t end)
               {
                 std::vector<dealii::Tensor<1, dim>> mean;
                 for (std::size_t c = begin; c < end; ++c)
                 {
                   double *f = &s.of_cells[c * n * dim];
                   double pressure = 0.;
                   for (unsigned int p = body.field.first_point(c); p < body.field.first_point(c + 1); ++p)
                   {
                     auto stress = s.stress[p];
                     if (body.f_bar)
                     {
                       const double mean_stress = trace(stress) / dim;
                       pressure += s.volume[p] * mean_stress;
                       for (unsigned int d = 0; d < dim; ++d)
                         stress[d][d] -= mean_stress;
                     }
                     // -V tau G^-T, so that every node costs one product with its slope.
                     dealii::Tensor<2, dim> q = -s.volume[p] * dealii::Tensor<2, dim>(stress);
                     if (!body.small_strain())
                       q = q * transpose(invert(s.grid_gradient[p]));
                     const dealii::Tensor<1, dim> *slope = body.field.slopes(p);
                     for (unsigned int k = 0; k < n; ++k)
                       for (unsigned int d = 0; d < dim; ++d)
                         f[dim * k + d] += q[d] * slope[k];
                   }
                   if (body.f_bar && body.field.first_point(c) < body.field.first_point(c + 1))
                   {
                     mean_slopes(body, c, mean);
                     for (unsigned int k = 0; k < n; ++k)
                       for (unsigned int d = 0; d < dim; ++d)
                         f[dim * k + d] -= pressure * mean[k][d];
                   }
                 }
               });
  body.field.gather(s.of_cells, s.nodal_increment);
  body.field.restrict(s.nodal_increment, force);
}

template <int dim>
void add_stiffness(const Body<dim> &body,
                   const double factor,
                   const bool guard_rotation,
                   SystemMatrix &matrix)
{
  for (const std::vector<unsigned int> &color : body.field.colors())
    parallel_for(color.size(), 8,
                 [&](const std::size_t begin, const std::size_t end)
                 {
                   Eigen::MatrixXd local, reduced;
                   for (std::size_t i = begin; i < end; ++i)
                   {
                     const unsigned int c = color[i];
                     cell_stiffness(body, c, guard_rotation, local);
                     const Eigen::MatrixXd &extension = body.field.cell_extension(c);
                     if (extension.size() == 0)
                     {
                       matrix.add_cell<dim>(body.field, c, local, factor);
                       continue;
                     }
                     // (E (x) I)^T local (E (x) I), direction by direction: both sides hold dim components
                     // per node.
                     const unsigned int m = extension.cols(), n = extension.rows();
                     Eigen::MatrixXd wide = Eigen::MatrixXd::Zero(dim * n, dim * m);
                     for (unsigned int a = 0; a < n; ++a)
                       for (unsigned int b = 0; b < m; ++b)
                         for (unsigned int d = 0; d < dim; ++d)
                           wide(dim * a + d, dim * b + d) = extension(a, b);
                     reduced.noalias() = wide.transpose() * (local * wide);
                     matrix.add_cell<dim>(body.field, c, reduced, factor);
                   }
                 });
}

template <int dim>
double stored_energy(const Body<dim> &body)
{
  double sum = 0.;
  for (unsigned int p = 0; p < body.points.size(); ++p)
    sum += body.step.energy[p] * body.step.volume[p];
  return sum;
}

#define INSTANTIATE(dim)                                                                                     \
  template StressOutcome evaluate_stress<dim>(Body<dim> &, const Eigen::VectorXd &, const Eigen::VectorXd &, \
                                              double, const StressWishes &);                                 \
  template void internal_force<dim>(Body<dim> &, Eigen::VectorXd &);                                         \
  template void add_stiffness<dim>(const Body<dim> &, double, bool, SystemMatrix &);                         \
  template double stored_energy<dim>(const Body<dim> &);
INSTANTIATE(2)
INSTANTIATE(3)
} // namespace softgrain::mpm
