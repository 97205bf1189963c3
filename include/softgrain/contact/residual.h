// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_residual_h
#define softgrain_contact_residual_h

#include <softgrain/contact/problem.h>

#include <cmath>
#include <vector>

namespace softgrain::contact
{
/// Projects @p x = (normal, tangents) on the Coulomb cone K = {|x_t| <= mu x_n}, in place.
template <unsigned int n>
void project_on_cone(const double mu, double (&x)[n])
{
  if constexpr (n == 1)
    x[0] = x[0] > 0. ? x[0] : 0.;
  else
  {
    double tangent = 0.;
    for (unsigned int c = 1; c < n; ++c)
      tangent += x[c] * x[c];
    tangent = std::sqrt(tangent);
    if (x[0] >= 0. && tangent <= mu * x[0]) // without friction and tangent 0 <= -0 holds anywhere
      return;
    const bool polar = mu * tangent <= -x[0];
    const double normal = polar ? 0. : (x[0] + mu * tangent) / (1. + mu * mu);
    const double factor = polar || tangent == 0. ? 0. : mu * normal / tangent;
    x[0] = normal;
    for (unsigned int c = 1; c < n; ++c)
      x[c] *= factor;
  }
}

/// Whether impulses lie on the edge of the Coulomb cone, as they do where a contact slides; but for rounding.
inline bool on_edge_of_cone(const double mu, const double normal, const double tangential)
{
  return tangential >= (1. - 1e-6) * mu * normal;
}

/**
 * @brief Natural map of one contact, as a velocity: |P - proj_K(P - ρ (w_n + mu |w_t|, w_t))| / ρ (m/s).
 *
 * Zero exactly where Signorini and Coulomb hold (de Saxcé's change of variable; Acary and Brogliato 2008, ch.
 * 13). With ρ = 1 / compliance it does not depend on the units of mass, and in one dimension it is |min(w, P
 * / ρ)|.
 */
template <unsigned int n>
double natural_map(const double *P, const double *w, const double mu, const double compliance)
{
  double x[n], tangent = 0.;
  for (unsigned int c = 1; c < n; ++c)
    tangent += w[c] * w[c];
  for (unsigned int c = 0; c < n; ++c)
    x[c] = compliance * P[c] - w[c];
  if constexpr (n > 1)
    x[0] -= mu * std::sqrt(tangent);
  project_on_cone<n>(mu, x);
  double sum = 0.;
  for (unsigned int c = 0; c < n; ++c)
    sum += (compliance * P[c] - x[c]) * (compliance * P[c] - x[c]);
  return std::sqrt(sum);
}

/**
 * @brief Compliance of each contact: trace(W_ii) / n_components (1/kg, in the plane m/kg), 0 when W_nn is 0.
 *
 * W_nn counts as 0 below 1e-20 of the largest: then both sides are prescribed and no impulse changes
 * anything.
 * @throw ComputationError when a block is not finite.
 */
template <class Operator>
std::vector<double> contact_compliance(const Operator &op);

/**
 * @brief Speed that impulses have to take away: the largest -q_n of contacts with a compliance (m/s), at
 * least 0.
 *
 * Gaps of open contacts (large positive q_n) and tangential speeds do not enter: neither makes impulses, and
 * a stop relative to them would leave the small impulses of a fast-sliding contact wrong. 0 means that P = 0
 * is a solution.
 */
double approach_speed(const Problem &problem, const std::vector<double> &compliance);

/**
 * @brief The stop criterion of the solvers: largest natural_map() over all contacts with a compliance,
 * divided by approach_speed() (dimensionless; does not change with the units of mass, length, time).
 *
 * When the approach speed is 0 the exact answer is P = 0; the result is then 0 or infinity.
 * @param problem the problem
 * @param compliance as contact_compliance() gives it
 * @param impulses P (N s per metre), n_contacts * n_components
 * @param velocities w = W P + q (m/s), n_contacts * n_components
 */
double natural_residual(const Problem &problem,
                        const std::vector<double> &compliance,
                        const std::vector<double> &impulses,
                        const std::vector<double> &velocities);

/**
 * @brief The residual that Siconos reports for the problems of its test data: ρ = 1,
 * ‖P - proj_K(P - (w_n + mu |w_t|, w_t))‖ / max(‖P‖, ‖w‖, ‖q‖) with Euclidean norms over all contacts.
 *
 * Mixes velocities and impulses, so it depends on units: for comparison only.
 */
double siconos_residual(const Problem &problem,
                        const std::vector<double> &impulses,
                        const std::vector<double> &velocities);

/// Largest approach speed max(-w_n) left in a contact whose impulse cannot change it (compliance 0), at least
/// 0.
double prescribed_approach(const Problem &problem,
                           const std::vector<double> &compliance,
                           const std::vector<double> &velocities);
} // namespace softgrain::contact

#endif
