// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/interruption.h>
#include <softgrain/contact/active_system.h>
#include <softgrain/contact/frictional_newton.h>
#include <softgrain/contact/residual.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace softgrain::contact
{
namespace
{
using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Relative difference up to which two residuals count as the same.
constexpr double same = 1e-3;

std::vector<double> to_vector(const Eigen::VectorXd &x)
{
  return std::vector<double>(x.data(), x.data() + x.size());
}

/// What one contact contributes: slip rows are `keep * dP_t - mu m dP_n + turn * (W dP)_t = right side`.
template <unsigned int n>
struct Contact
{
  bool closed = false;
  bool slips = false;
  double turn = 0.; // k ρ
  double k = 0.;    // mu (P_n - ρ w_n) / |P_t - ρ w_t|
  std::array<double, n - 1> m = {};
};

template <unsigned int n>
std::vector<Contact<n>> classify(const Problem &problem,
                                 const std::vector<double> &compliance,
                                 const Eigen::VectorXd &P,
                                 const Eigen::VectorXd &w)
{
  std::vector<Contact<n>> contacts(problem.n_contacts());
  for (unsigned int i = 0; i < contacts.size(); ++i)
    if (compliance[i] > 0.)
    {
      const double rho = 1. / compliance[i];
      const double normal = P[i * n] - rho * w[i * n];
      contacts[i].closed = normal > 0.;
      double length = 0.;
      for (unsigned int c = 1; c < n; ++c)
      {
        contacts[i].m[c - 1] = P[i * n + c] - rho * w[i * n + c];
        length += contacts[i].m[c - 1] * contacts[i].m[c - 1];
      }
      length = std::sqrt(length);
      const double mu = problem.friction_of(i);
      contacts[i].slips = contacts[i].closed && length > mu * normal;
      if (contacts[i].slips)
      {
        for (double &value : contacts[i].m)
          value /= length;
        contacts[i].k = mu * normal / length;
        contacts[i].turn = contacts[i].k * rho;
      }
    }
  return contacts;
}

/// Open where the impulse is none, slips where it lies on the cone.
template <unsigned int n>
std::vector<Contact<n>>
classify_by_impulses(const Problem &problem, const std::vector<double> &compliance, const Eigen::VectorXd &P)
{
  std::vector<Contact<n>> contacts(problem.n_contacts());
  for (unsigned int i = 0; i < contacts.size(); ++i)
  {
    contacts[i].closed = compliance[i] > 0. && P[i * n] > 0.;
    const double length = P.segment<n - 1>(i * n + 1).norm();
    contacts[i].slips = contacts[i].closed && on_edge_of_cone(problem.friction_of(i), P[i * n], length);
    if (!contacts[i].slips)
      continue;
    for (unsigned int c = 1; c < n; ++c)
      contacts[i].m[c - 1] = length > 0. ? P[i * n + c] / length : 0.;
    contacts[i].k = 1.;
    contacts[i].turn = 1. / compliance[i];
  }
  return contacts;
}

/// Numbers of the components of closed contacts among these; -1 for the others.
template <unsigned int n>
std::vector<int> numbers_of_closed(const std::vector<Contact<n>> &contacts)
{
  std::vector<int> local(n * contacts.size(), -1);
  int size = 0;
  for (unsigned int i = 0; i < contacts.size(); ++i)
    for (unsigned int c = 0; c < n; ++c)
      if (contacts[i].closed)
        local[i * n + c] = size++;
  return local;
}

/// How many entries of the matrix are in rows and columns that have numbers.
std::size_t entries_of(const Matrix &W, const std::vector<int> &local)
{
  std::size_t sum = 0;
  for (unsigned int row = 0; row < local.size(); ++row)
    if (local[row] >= 0)
      for (Matrix::InnerIterator entry(W, row); entry; ++entry)
        sum += local[entry.col()] >= 0;
  return sum;
}

/// The equations of the Newton step for the components of closed contacts.
template <unsigned int n>
class NewtonEquations
{
public:
  /// All are kept by reference. @param step known of the components of open contacts, 0 elsewhere
  NewtonEquations(const Matrix &W,
                  const std::vector<double> &compliance,
                  const std::vector<int> &local,
                  const unsigned int size,
                  const double epsilon,
                  const Eigen::VectorXd &step)
      : W(W)
      , compliance(compliance)
      , local(local)
      , epsilon(epsilon)
      , from_opened(W * step)
      , system(size, entries_of(W, local) + 3 * size, false)
      , b(Eigen::VectorXd::Zero(size))
  {
  }

  /// Adds those of contact @p i. Rows are in units of velocity, so that pivoting compares like with like.
  void add(const unsigned int i,
           const Contact<n> &contact,
           const double mu,
           const Eigen::VectorXd &P,
           const Eigen::VectorXd &w)
  {
    add_row(i * n, i * n, 1.);
    b[local[i * n]] -= w[i * n];
    for (unsigned int c = 1; c < n; ++c)
    {
      const unsigned int row = i * n + c;
      if (!contact.slips)
      {
        add_row(row, row, 1.);
        b[local[row]] -= w[row];
        continue;
      }
      const double unit = compliance[i];
      b[local[row]] += unit * (mu * P[i * n] * contact.m[c - 1] - P[row]);
      system.add(local[row], local[i * n], -unit * mu * contact.m[c - 1]);
      system.add(local[row], local[row], unit);
      if constexpr (n > 2)
        for (unsigned int d = 1; d < n; ++d)
        {
          const double normal_part = (c == d ? 1. : 0.) - contact.m[c - 1] * contact.m[d - 1];
          system.add(local[row], local[i * n + d], -unit * contact.k * normal_part);
          add_row(row, i * n + d, unit * contact.turn * normal_part);
          // F_t itself: the part of P_t - ρ w_t across m is 0, so only the value of mu P_n m - P_t stays
        }
    }
  }

  /// @return whether there is a solution
  bool solve(Eigen::VectorXd &solution) { return system.solve_general(b, solution); }

private:
  /// Adds factor * ((W + ε D) dP)_from to the equation of row @p to.
  void add_row(const unsigned int to, const unsigned int from, const double factor)
  {
    for (Matrix::InnerIterator entry(W, from); entry; ++entry)
      if (local[entry.col()] >= 0)
        system.add(local[to], local[entry.col()], factor * entry.value());
    system.add(local[to], local[from], factor * epsilon * compliance[from / n]);
    b[local[to]] -= factor * from_opened[from];
  }

  const Matrix &W;
  const std::vector<double> &compliance;
  const std::vector<int> &local;
  const double epsilon;
  const Eigen::VectorXd from_opened; ///< W times what is known of the step
  ActiveSystem system;
  Eigen::VectorXd b;
};

/// The Newton step; false when its system is singular.
template <unsigned int n>
bool newton_step(const Matrix &W,
                 const Problem &problem,
                 const std::vector<double> &compliance,
                 const std::vector<Contact<n>> &contacts,
                 const double epsilon,
                 const Eigen::VectorXd &P,
                 const Eigen::VectorXd &w,
                 Eigen::VectorXd &step)
{
  const std::vector<int> local = numbers_of_closed<n>(contacts);
  const unsigned int size =
      std::count_if(local.begin(), local.end(), [](const int number) { return number >= 0; });
  step = Eigen::VectorXd::Zero(P.size());
  for (unsigned int row = 0; row < local.size(); ++row)
    if (local[row] < 0)
      step[row] = -P[row];
  if (size == 0)
    return true;
  NewtonEquations<n> equations(W, compliance, local, size, epsilon, step);
  for (unsigned int i = 0; i < contacts.size(); ++i)
    if (contacts[i].closed)
      equations.add(i, contacts[i], problem.friction_of(i), P, w);
  Eigen::VectorXd solution;
  if (!equations.solve(solution))
    return false;
  for (unsigned int row = 0; row < local.size(); ++row)
    if (local[row] >= 0)
      step[row] = solution[local[row]];
  return true;
}

/// How far to go along a step, and the residual there: halved until @p residual of a factor is less than @p
/// here by as much as may be expected, or as often as is allowed.
template <class Residual>
std::pair<double, double> best_factor(const unsigned int trials, const double here, const Residual &residual)
{
  double factor = 1., chosen = 1., lowest = std::numeric_limits<double>::infinity();
  for (unsigned int trial = 0; trial < trials; ++trial, factor *= 0.5)
  {
    const double value = residual(factor);
    if (value < lowest)
    {
      lowest = value;
      chosen = factor;
    }
    if (value < (1. - 0.1 * factor) * here)
      break;
  }
  return {chosen, lowest};
}
} // namespace

template <unsigned int n>
double frictional_newton(const Matrix &W,
                         const Problem &problem,
                         const std::vector<double> &compliance,
                         const SolverSettings &settings,
                         const bool trust_impulses,
                         std::vector<double> &impulses,
                         SolverReport &report)
{
  const Eigen::Map<const Eigen::VectorXd> q(problem.free_velocity.data(), problem.free_velocity.size());
  const auto residual = [&](const Eigen::VectorXd &P, const Eigen::VectorXd &w)
  { return natural_residual(problem, compliance, to_vector(P), to_vector(w)); };
  Eigen::VectorXd P = Eigen::Map<const Eigen::VectorXd>(impulses.data(), impulses.size()), step;
  Eigen::VectorXd w = W * P + q;
  double here = residual(P, w), best = here, epsilon = 1e-10;
  const double speed = approach_speed(problem, compliance);
  unsigned int uphill = 0, since_best = 0;
  bool trusting = trust_impulses;
  while (best > settings.tolerance && report.newton_iterations < settings.max_newton_iterations)
  {
    stop_if_interrupted();
    ++report.newton_iterations;
    const std::vector<Contact<n>> contacts =
        trusting ? classify_by_impulses<n>(problem, compliance, P) : classify<n>(problem, compliance, P, w);
    if (!newton_step<n>(W, problem, compliance, contacts, epsilon, P, w, step))
    {
      ++report.regularised;
      epsilon *= 100.;
      if (epsilon > 1e-4)
        break;
      continue;
    }
    const Eigen::VectorXd W_step = W * step;
    // The step that brings what is trusted into balance is taken whole: halfway the imbalance rules.
    const unsigned int trials = trusting ? 1 : 6;
    trusting = false;
    auto [chosen, lowest] = best_factor(
        trials, here, [&](const double factor) { return residual(P + factor * step, w + factor * W_step); });
    // A few steps may go uphill: the sets of stick and slip often change in between before they settle.
    if (!(lowest < here))
    {
      if (++uphill > 3 || best <= rounding_floor(W, impulses, speed))
        break;
      chosen = 1.;
    }
    P += chosen * step;
    w = W * P + q;
    here = residual(P, w);
    if (!std::isfinite(here))
      break;
    // The best residual again, after others: Newton repeats the same sets of stick and slip.
    if (since_best > 0 && std::abs(here - best) <= same * best)
      report.came_back = true;
    ++since_best;
    if (here < best)
    {
      best = here;
      impulses = to_vector(P);
      uphill = since_best = 0;
    }
    if (report.came_back)
      break;
  }
  return best;
}

template double frictional_newton<2>(const Matrix &,
                                     const Problem &,
                                     const std::vector<double> &,
                                     const SolverSettings &,
                                     bool,
                                     std::vector<double> &,
                                     SolverReport &);
template double frictional_newton<3>(const Matrix &,
                                     const Problem &,
                                     const std::vector<double> &,
                                     const SolverSettings &,
                                     bool,
                                     std::vector<double> &,
                                     SolverReport &);
} // namespace softgrain::contact
