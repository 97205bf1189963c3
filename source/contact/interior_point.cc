// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/interruption.h>
#include <softgrain/contact/active_system.h>
#include <softgrain/contact/frictional_newton.h>
#include <softgrain/contact/interior_point.h>
#include <softgrain/contact/residual.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace softgrain::contact
{
namespace
{
using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Array = Eigen::ArrayXd;

/// Per contact: P_n, β₊, β₋, λ, or what each is complementary to.
using Four = std::array<Array, 4>;

class InteriorPoint
{
public:
  InteriorPoint(const Matrix &W,
                const Problem &problem,
                const std::vector<double> &compliance,
                const std::vector<double> &impulses)
      : problem(problem), speed(approach_speed(problem, compliance))
  {
    for (unsigned int i = 0; i < problem.n_contacts(); ++i)
      if (compliance[i] > 0. && (impulses[2 * i] > 0. || problem.free_velocity[2 * i] < far * speed))
        contacts.push_back(i);
    const unsigned int n = contacts.size();
    std::vector<int> local(W.rows(), -1);
    q.resize(2 * n);
    mu.resize(n);
    for (unsigned int k = 0; k < n; ++k)
    {
      mu[k] = std::max(problem.friction_of(contacts[k]), 1e-3); // a cone of no width has no interior
      for (unsigned int c = 0; c < 2; ++c)
      {
        local[2 * contacts[k] + c] = 2 * k + c;
        q[2 * k + c] = problem.free_velocity[2 * contacts[k] + c] / speed;
      }
    }
    for (int row = 0; row < W.rows(); ++row)
      for (Matrix::InnerIterator entry(W, row); entry; ++entry)
        if (local[row] >= 0 && local[entry.col()] >= 0)
          entries.emplace_back(local[row], local[entry.col()], entry.value());
    A.resize(2 * n, 2 * n);
    original.resize(2 * n, 2 * n);
    original.setFromTriplets(entries.begin(), entries.end());
    unit = usual_impulse * speed / elastic_compliance();
    A = original * (unit / speed);
    for (unsigned int v = 0; v < 4; ++v)
    {
      x[v] = Array::Constant(n, v == 1 || v == 2 ? 0.3 : 1.);
      s[v] = Array::Ones(n);
    }
  }

  /// One step; false when nothing can be solved any more.
  bool step()
  {
    const unsigned int n = contacts.size();
    Eigen::VectorXd P(2 * n);
    for (unsigned int k = 0; k < n; ++k)
    {
      P[2 * k] = x[0][k];
      P[2 * k + 1] = x[1][k] - x[2][k];
    }
    const Eigen::VectorXd w = A * P + q;
    const Array w_n = normal(w), w_t = tangential(w);
    error = {s[0] - w_n, s[1] - w_t - x[3], s[2] + w_t - x[3], s[3] - mu * x[0] + x[1] + x[2]};
    for (unsigned int v = 0; v < 4; ++v)
      D[v] = s[v] / x[v];
    sum = 1. / D[1] + 1. / D[2];
    difference = 1. / D[1] - 1. / D[2];
    k_lambda = 1. / (D[3] + sum);
    g = (sum * D[3] + 4. / (D[1] * D[2])) * k_lambda;

    ActiveSystem system(2 * n, entries.size() + 3 * n);
    for (int row = 0; row < A.rows(); ++row)
      for (Matrix::InnerIterator entry(A, row); entry; ++entry)
        system.add(row, entry.col(), entry.value());
    for (unsigned int k = 0; k < n; ++k)
    {
      system.add(2 * k, 2 * k, D[0][k]);
      system.add(2 * k + 1, 2 * k + 1, 1. / g[k]);
      system.add(2 * k + 1, 2 * k, -difference[k] * k_lambda[k] * mu[k] / g[k]);
    }
    if (!system.factorise_general())
      return false;
    Four dx, ds, products;
    for (unsigned int v = 0; v < 4; ++v)
      products[v] = x[v] * s[v];
    solve(system, products, dx, ds);
    const double length = longest(dx, ds), now = mean_product(0., dx, ds);
    const double after = mean_product(length, dx, ds) / now;
    const double target = now * (length > 0.1 ? std::max(after * after * after, 1e-3) : 0.5);
    for (unsigned int v = 0; v < 4; ++v)
      products[v] += length * length * dx[v] * ds[v] - target;
    solve(system, products, dx, ds);
    const double factor = std::min(1., 0.95 * longest(dx, ds));
    for (unsigned int v = 0; v < 4; ++v)
    {
      x[v] += factor * dx[v];
      s[v] += factor * ds[v];
      if (!x[v].allFinite() || !s[v].allFinite() || !(x[v].minCoeff() > 0.) || !(s[v].minCoeff() > 0.))
        return false;
    }
    return true;
  }

  /// The impulses as they look now: open ones 0, those that slip on the cone.
  std::vector<double> guess() const
  {
    std::vector<double> P(problem.free_velocity.size(), 0.);
    for (unsigned int k = 0; k < contacts.size(); ++k)
    {
      if (x[0][k] <= s[0][k])
        continue;
      const unsigned int i = contacts[k];
      const double edge = problem.friction_of(i) * x[0][k];
      const bool on_cone = s[3][k]<x[3][k], up = x[1][k]> s[1][k], down = x[2][k] > s[2][k];
      const double tangent = std::clamp(x[1][k] - x[2][k], -0.999 * edge, 0.999 * edge);
      P[2 * i] = unit * x[0][k];
      P[2 * i + 1] = unit * (on_cone && up && !down ? edge : on_cone && down && !up ? -edge : tangent);
    }
    return P;
  }

private:
  static Array normal(const Eigen::VectorXd &v)
  {
    return Eigen::Map<const Array, 0, Eigen::InnerStride<2>>(v.data(), v.size() / 2);
  }
  static Array tangential(const Eigen::VectorXd &v)
  {
    return Eigen::Map<const Array, 0, Eigen::InnerStride<2>>(v.data() + 1, v.size() / 2);
  }

  /// The step for which the products x s change by -@p products, to first order.
  void solve(const ActiveSystem &system, const Four &products, Four &dx, Four &ds) const
  {
    Four r;
    for (unsigned int v = 0; v < 4; ++v)
      r[v] = error[v] - products[v] / x[v];
    const Array R = r[3] + r[1] / D[1] + r[2] / D[2];
    const Array in_t = (r[1] / D[1] - r[2] / D[2] - difference * k_lambda * R) / g;
    Eigen::VectorXd b(2 * R.size());
    for (unsigned int k = 0; k < R.size(); ++k)
    {
      b[2 * k] = r[0][k];
      b[2 * k + 1] = in_t[k];
    }
    const Eigen::VectorXd d = system.solve_with_factors(b), change = A * d;
    const Array y = tangential(change);
    dx[0] = normal(d);
    dx[3] = k_lambda * (R - mu * dx[0] - difference * y);
    dx[1] = (r[1] - y - dx[3]) / D[1];
    dx[2] = (r[2] + y - dx[3]) / D[2];
    for (unsigned int v = 0; v < 4; ++v)
      ds[v] = -(products[v] + s[v] * dx[v]) / x[v];
  }

  /// How far a step may go, at most 1, until something is 0.
  double longest(const Four &dx, const Four &ds) const
  {
    double length = 1.;
    for (unsigned int v = 0; v < 4; ++v)
      for (unsigned int k = 0; k < contacts.size(); ++k)
      {
        if (dx[v][k] < 0.)
          length = std::min(length, -x[v][k] / dx[v][k]);
        if (ds[v][k] < 0.)
          length = std::min(length, -s[v][k] / ds[v][k]);
      }
    return length;
  }

  double mean_product(const double length, const Four &dx, const Four &ds) const
  {
    double total = 0.;
    for (unsigned int v = 0; v < 4; ++v)
      total += ((x[v] + length * dx[v]) * (s[v] + length * ds[v])).sum();
    return total / (4. * contacts.size());
  }

  /// Of a contact when all others are held: 1 / (W⁻¹)_ii, the median of some. Motions of whole bodies are not
  /// in it.
  double elastic_compliance() const
  {
    const int n = original.rows();
    ActiveSystem system(n, entries.size() + n);
    for (const auto &entry : entries)
      system.add(entry.row(), entry.col(), entry.value());
    const double largest = original.diagonal().maxCoeff();
    for (int i = 0; i < n; ++i)
      system.add(i, i, 1e-12 * largest);
    std::vector<double> sample;
    if (system.factorise_general())
      for (int i = 0; i < n; i += std::max(1, n / 24))
      {
        const double inverse = system.solve_with_factors(Eigen::VectorXd::Unit(n, i))[i];
        if (inverse > 0. && std::isfinite(inverse))
          sample.push_back(1. / inverse);
      }
    if (sample.empty())
      return largest;
    std::nth_element(sample.begin(), sample.begin() + sample.size() / 2, sample.end());
    return sample[sample.size() / 2];
  }

  /// Contacts that part faster than this many times the speed of approach are left out: most rows are of
  /// bodies close to each other that will not meet. Should one of them close, Newton finds it.
  static constexpr double far = 1.1;
  /// Unit of impulse, as a share of what an elastic contact needs to stop the approach.
  static constexpr double usual_impulse = 0.1;

  const Problem &problem;
  std::vector<unsigned int> contacts; ///< that may close
  std::vector<Eigen::Triplet<double>> entries;
  Matrix original, A; ///< W; in the units of speed and impulse
  Eigen::VectorXd q;
  Array mu;
  double speed, unit = 1.; ///< [m/s], [N s/m]
  Four x, s, error, D;
  Array sum, difference, k_lambda, g;
};
} // namespace

double interior_point(const Matrix &W,
                      const Problem &problem,
                      const std::vector<double> &compliance,
                      const SolverSettings &settings,
                      std::vector<double> &impulses,
                      SolverReport &report)
{
  constexpr unsigned int most_steps = 40, steps_between_tries = 4;
  double best = std::numeric_limits<double>::infinity();
  if (approach_speed(problem, compliance) == 0.)
    return best;
  InteriorPoint points(W, problem, compliance, impulses);
  for (unsigned int k = 1; k <= most_steps && points.step(); ++k)
  {
    stop_if_interrupted();
    ++report.newton_iterations;
    if (k % steps_between_tries != 0)
      continue;
    std::vector<double> trial = points.guess();
    SolverSettings brief = settings;
    brief.max_newton_iterations = 6; // it ends at once or not at all
    SolverReport attempt;
    const double residual = frictional_newton<2>(W, problem, compliance, brief, true, trial, attempt);
    report.newton_iterations += attempt.newton_iterations;
    if (residual < best)
    {
      best = residual;
      impulses.swap(trial);
    }
    if (best <= settings.tolerance)
      return best;
  }
  return best;
}
} // namespace softgrain::contact
