// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/pressed_body.h>
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/stiffness.h>
#include <softgrain/mpm/stepping/stress.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace softgrain::mpm
{
namespace
{
constexpr double softness_of_places = 1e-3; ///< over Young's modulus and the edge of a cell
constexpr double gap_tolerance = 1e-5;      ///< [cells]
constexpr double candidates_within = 0.5;   ///< gap of places that may touch in an iteration [cells]
constexpr double longest_way = 0.3;         ///< of a place in an iteration [cells]
/// In space factors fill so that a band is best up to some 1500 nodes.
constexpr unsigned int widest_band = 2000;
constexpr double rise = 10.; ///< of α, where there is no minimum
constexpr unsigned int most_rises = 8;
constexpr double locked = 1e4; ///< of the torque that keeps a round body from turning, see StepEquations
constexpr unsigned int most_halvings = 8; ///< of a way that cannot be gone
} // namespace

template <int dim>
PressedBody<dim>::PressedBody(Body<dim> &body,
                              const std::vector<std::vector<dealii::Point<dim>>> &places,
                              const Settings &settings,
                              const double cell_size)
    : body(body)
    , settings(settings)
    , cell_size(cell_size)
    , places(places)
    , weights(body.mass.cwiseAbs() / body.mass.sum())
{
  for (const std::vector<dealii::Point<dim>> &of_wall : places)
  {
    force.emplace_back(of_wall.size(), 0.);
    functions.emplace_back();
    for (const dealii::Point<dim> &x : of_wall)
      functions.back().push_back(body.field.functions_at(x));
  }
  lay_out_stiffness(body.field, matrix);
  LinearSolverSettings of_space = settings.linear_solver;
  of_space.automatic_band = widest_band;
  solver = std::make_unique<LowRankSolver>(create_linear_solver(of_space, matrix, dim, true));
  usual_shift =
      settings.regularisation * body.law->young_modulus() * std::pow(body.rest_area, (dim - 2.) / dim);
  against_rotation = 30. * locked * body.law->young_modulus() * body.rest_area;
  start = body.displacement;
  find_rotations();
  evaluate(body.displacement);
}

template <int dim>
void PressedBody<dim>::find_rotations()
{
  const unsigned int n = body.field.n_independent();
  const auto place_of = [&](const unsigned int i)
  {
    return body.field.position(body.field.node_of_independent(i)) +
           PlaceFunctions<dim>::of_node(body.displacement, i);
  };
  Vector center;
  for (unsigned int i = 0; i < n; ++i)
    center += body.mass[i] / body.mass.sum() * (place_of(i) - dealii::Point<dim>());
  rotations.setZero(dim * n, dim == 2 ? 1 : 3);
  for (unsigned int axis = 0; axis < rotations.cols(); ++axis)
  {
    // Displacements of a turn by one radian.
    Eigen::VectorXd turn = Eigen::VectorXd::Zero(dim * n);
    const unsigned int from = dim == 2 ? 0 : (axis + 1) % 3, to = dim == 2 ? 1 : (axis + 2) % 3;
    double inertia = 0.;
    for (unsigned int i = 0; i < n; ++i)
    {
      const Vector arm = place_of(i) - dealii::Point<dim>(center);
      turn[dim * i + from] = -arm[to];
      turn[dim * i + to] = arm[from];
      inertia += body.mass[i] * (arm[from] * arm[from] + arm[to] * arm[to]);
      rotations.col(axis).template segment<dim>(dim * i) = body.mass[i] * turn.template segment<dim>(dim * i);
    }
    rotations.col(axis) /= inertia;
  }
}

template <int dim>
dealii::Point<dim> PressedBody<dim>::place(const std::size_t wall, const std::size_t k) const
{
  return places[wall][k] + functions[wall][k].at(body.displacement);
}

template <int dim>
double PressedBody<dim>::total_force(const std::size_t wall) const
{
  return std::accumulate(force[wall].begin(), force[wall].end(), 0.);
}

template <int dim>
std::string PressedBody<dim>::evaluate(const Eigen::VectorXd &u)
{
  Trial asked;
  asked.tangent = true;
  asked.max_strain = settings.max_strain;
  const StressOutcome outcome = evaluate_stress(body, u, Eigen::VectorXd(u - start), asked, trial);
  if (!outcome.good())
    return "body '" + body.name + "': a material point near (" + outcome.place + ") m " +
           (outcome.leaps             ? "is strained by more than 'Newton/Largest strain'"
            : outcome.refusal.empty() ? "turns inside out"
                                      : outcome.refusal);
  internal_force(body, trial, internal);
  holding = rotations * (-against_rotation * (rotations.transpose() * (u - start)));
  return "";
}

template <int dim>
void PressedBody<dim>::measure(const std::vector<FlatWall> &walls, Outcome &outcome)
{
  Eigen::VectorXd contact_force = Eigen::VectorXd::Zero(internal.size());
  outcome.deepest = 0.;
  const double softness = softness_of_places / (body.law->young_modulus() * std::pow(cell_size, dim - 2.));
  for (std::size_t w = 0; w < walls.size(); ++w)
  {
    const double dent = walls[w].dent(total_force(w));
    for (std::size_t k = 0; k < places[w].size(); ++k)
    {
      const double P = force[w][k];
      const double gap = (place(w, k) - walls[w].point) * walls[w].normal + dent + softness * P;
      outcome.deepest = std::max(outcome.deepest, P > 0. ? std::abs(gap) : -gap);
      if (P > 0.)
        for (unsigned int i = 0; i < functions[w][k].node.size(); ++i)
          for (unsigned int d = 0; d < dim; ++d)
            contact_force[dim * functions[w][k].node[i] + d] +=
                P * functions[w][k].value[i] * walls[w].normal[d];
    }
  }
  const double scale = std::max({contact_force.norm(), internal.norm(),
                                 1e-8 * body.law->wave_modulus() * std::pow(cell_size, dim - 1.)});
  outcome.residual = (internal + holding + contact_force).norm() / scale;
}

template <int dim>
void PressedBody<dim>::find_candidates(const std::vector<FlatWall> &walls)
{
  candidates.clear();
  std::vector<double> gaps;
  for (std::size_t w = 0; w < walls.size(); ++w)
    for (std::size_t k = 0; k < places[w].size(); ++k)
    {
      const double gap = (place(w, k) - walls[w].point) * walls[w].normal;
      if (force[w][k] == 0. && gap > candidates_within * cell_size)
        continue;
      candidates.push_back({w, k});
      gaps.push_back(gap);
    }
  contact.gap = Eigen::Map<const Eigen::VectorXd>(gaps.data(), gaps.size());
  gradients.resize(body.field.n_dofs(), candidates.size());
  gradients.setZero();
  gradients.reserve(candidates.size() * 40 * dim);
  for (unsigned int c = 0; c < candidates.size(); ++c)
  {
    gradients.startVec(c);
    const PlaceFunctions<dim> &function = functions[candidates[c].wall][candidates[c].place];
    for (unsigned int i = 0; i < function.node.size(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        gradients.insertBack(dim * function.node[i] + d, c) =
            function.value[i] * walls[candidates[c].wall].normal[d];
  }
  gradients.finalize();
}

template <int dim>
std::string PressedBody<dim>::find_forces(const std::vector<FlatWall> &walls, Outcome &outcome)
{
  const Eigen::VectorXd gap_here = contact.gap;
  const double softness = softness_of_places / (body.law->young_modulus() * std::pow(cell_size, dim - 2.));
  for (unsigned int attempt = 0; attempt <= most_rises; ++attempt, shift *= rise)
  {
    matrix.set_zero();
    add_stiffness(body, trial, 1., matrix);
    matrix.template add_mass<dim>(weights, shift);
    solver->set_update(rotations, against_rotation);
    if (!solver->factorize(matrix))
      continue;
    Eigen::VectorXd way;
    solver->solve(Eigen::VectorXd(internal + holding), way);
    contact.gap = gap_here + gradients.transpose() * way;
    if (!candidates.empty())
      solver->condense(gradients, contact.compliance);
    else
      contact.compliance.resize(0, 0);
    for (unsigned int c = 0; c < candidates.size(); ++c)
      contact.compliance(c, c) += softness;
    for (std::size_t w = 0; w < walls.size(); ++w)
    {
      const double total = total_force(w), slope = walls[w].dent.slope(total),
                   free = walls[w].dent(total) - slope * total;
      for (unsigned int c = 0; c < candidates.size(); ++c)
        if (candidates[c].wall == w)
        {
          contact.gap[c] += free;
          for (unsigned int e = 0; e < candidates.size(); ++e)
            if (candidates[e].wall == w)
              contact.compliance(c, e) += slope;
        }
    }
    contact.closed.resize(candidates.size());
    for (unsigned int c = 0; c < candidates.size(); ++c)
      contact.closed[c] = force[candidates[c].wall][candidates[c].place] > 0.;
    const bool settled = contact.solve(1e-10 * cell_size);
    outcome.passes += contact.passes;
    if (settled && contact.n_negative() == solver->n_negative().value_or(0))
      return "";
  }
  return "body '" + body.name + "': no forces of contacts are found that hold it";
}

template <int dim>
std::string PressedBody<dim>::go(const Eigen::VectorXd &direction, const Forces &to, double share)
{
  const Eigen::VectorXd from = body.displacement;
  const Forces before = force;
  std::string trouble;
  for (unsigned int halving = 0; halving <= most_halvings; ++halving, share *= 0.5)
  {
    body.displacement = from + share * direction;
    trouble = evaluate(body.displacement);
    if (!trouble.empty())
      continue;
    for (std::size_t w = 0; w < force.size(); ++w)
      for (std::size_t k = 0; k < places[w].size(); ++k)
        force[w][k] = before[w][k] + share * (to[w][k] - before[w][k]);
    return "";
  }
  return trouble;
}

template <int dim>
std::string PressedBody<dim>::iterate(const std::vector<FlatWall> &walls, Outcome &outcome)
{
  find_candidates(walls);
  if (std::string trouble = find_forces(walls, outcome); !trouble.empty())
    return trouble;
  Eigen::VectorXd direction;
  solver->solve(Eigen::VectorXd(internal + holding + gradients * contact.force), direction);
  Forces to = force;
  for (std::vector<double> &of_wall : to)
    std::fill(of_wall.begin(), of_wall.end(), 0.);
  for (unsigned int c = 0; c < candidates.size(); ++c)
    to[candidates[c].wall][candidates[c].place] = contact.force[c];
  // Nodes of cells that hold little of the body go far where its places do not.
  double largest = 0.;
  for (const std::vector<PlaceFunctions<dim>> &of_wall : functions)
    for (const PlaceFunctions<dim> &function : of_wall)
      largest = std::max(largest, function.at(direction).norm());
  return go(direction, to, std::min(1., longest_way * cell_size / std::max(largest, 1e-300)));
}

template <int dim>
typename PressedBody<dim>::Outcome PressedBody<dim>::balance(const std::vector<FlatWall> &walls)
{
  Outcome outcome;
  const Forces forces_before = force;
  start = body.displacement;
  shift = usual_shift;
  find_rotations();
  outcome.trouble = evaluate(body.displacement);
  measure(walls, outcome);
  while (outcome.trouble.empty() &&
         !(outcome.residual < settings.residual_tolerance && outcome.deepest < gap_tolerance * cell_size))
  {
    if (outcome.iterations == settings.max_newton)
    {
      outcome.trouble = "Newton's method has not converged in " + std::to_string(outcome.iterations) +
                        " iterations, residual " + short_number(outcome.residual);
      break;
    }
    ++outcome.iterations;
    shift = std::max(usual_shift, 0.1 * shift);
    outcome.trouble = iterate(walls, outcome);
    if (outcome.trouble.empty())
      measure(walls, outcome);
  }
  if (!outcome.trouble.empty())
  {
    force = forces_before;
    body.displacement = start;
    evaluate(start);
  }
  return outcome;
}

template <int dim>
std::string PressedBody<dim>::take(const Eigen::VectorXd &displacement,
                                   const std::vector<std::vector<double>> &forces)
{
  start = body.displacement = displacement;
  force = forces;
  find_rotations();
  return evaluate(displacement);
}

template class PressedBody<3>;
} // namespace softgrain::mpm
