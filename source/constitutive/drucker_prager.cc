// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/constitutive/deformation.h>
#include <softgrain/constitutive/drucker_prager.h>
#include <softgrain/constitutive/law_registry.h>
#include <softgrain/constitutive/logarithmic_strain.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>

namespace softgrain::constitutive
{
template <int dim>
void DruckerPrager<dim>::declare_parameters(dealii::ParameterHandler &prm) const
{
  using dealii::Patterns::Double;
  ElasticLaw<dim>::declare_parameters(prm);
  prm.declare_entry("Cohesion", "2e5", Double(0.),
                    "d, von Mises stress at yield without pressure, above 0. Units: Pa.");
  prm.declare_entry("Friction", "0.5", Double(0.),
                    "m, rise of the von Mises stress at yield per pressure. Units: none.");
  prm.declare_entry("Cap start", "1e6", Double(0.), "p_a, pressure at which the cap begins. Units: Pa.");
  prm.declare_entry("Cap pressure", "2e6", Double(0.),
                    "p_b, pressure at which the solid yields without shear, above that at which the cap "
                    "begins. Units: Pa.");
  prm.declare_entry("Cap hardening", "0", Double(0.),
                    "H, by how much both pressures of the cap rise per plastic compaction (logarithm of the "
                    "volume), at most the bulk modulus. Units: Pa.");
}

template <int dim>
void DruckerPrager<dim>::parse_parameters(dealii::ParameterHandler &prm)
{
  ElasticLaw<dim>::parse_parameters(prm);
  cohesion = prm.get_double("Cohesion");
  friction = prm.get_double("Friction");
  cap_start = prm.get_double("Cap start");
  cap_end = prm.get_double("Cap pressure");
  cap_hardening = prm.get_double("Cap hardening");
  if (const double bulk = this->lambda + 2. / 3. * this->mu; !(cap_hardening <= bulk))
    throw InputError("Cap hardening = " + prm.get("Cap hardening") +
                     " Pa is not allowed; it must be at most the bulk modulus, which is " +
                     std::to_string(bulk) + " Pa");
  if (!(cohesion > 0))
    throw InputError("Cohesion = " + prm.get("Cohesion") + " Pa is not allowed; it must be above 0");
  if (!(cap_end > cap_start))
    throw InputError("Cap pressure = " + prm.get("Cap pressure") +
                     " Pa is not allowed; it must be above Cap start = " + prm.get("Cap start") + " Pa");
}

template <int dim>
void DruckerPrager<dim>::initial_history(double *history) const
{
  std::fill(history, history + n_history(), 0.);
  for (unsigned int i = 0; i < dim; ++i)
    history[i * (dim + 1)] = 1;
  if (dim == 2)
    history[4] = 1;
}

template <int dim>
std::vector<std::string> DruckerPrager<dim>::history_names() const
{
  const std::string axes = "xyz";
  std::vector<std::string> names;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = 0; j < dim; ++j)
      names.push_back(std::string("inverse_plastic_") + axes[i] + axes[j]);
  if (dim == 2)
    names.push_back("inverse_plastic_zz");
  names.insert(names.end(), {"plastic_shear", "plastic_compaction", "cap_compaction"});
  return names;
}

template <int dim>
typename DruckerPrager<dim>::Cap DruckerPrager<dim>::cap_after(const double compaction) const
{
  const double start = cap_start + cap_hardening * compaction;
  return {start, cap_end + cap_hardening * compaction, cohesion + friction * start};
}

template <int dim>
typename DruckerPrager<dim>::Projection
DruckerPrager<dim>::project_on_cap(const double p, const double q, const Cap &cap) const
{
  // In u and y the elastic energy is (u^2 + y^2) / (6 mu), up to a shift, and the cap an ellipse of half axes
  // A, B. All are stresses: a root of a stress would not be the same bits in all units.
  const double a = std::sqrt((this->lambda + 2. / 3. * this->mu) / (3 * this->mu));
  const double A = (cap.end - cap.start) / a, B = cap.top;
  const double u_trial = (p - cap.start) / a, y_trial = q;
  // u = u_trial / (1 + t/A^2), and so for y: what is left over is convex in t and falls; Newton from the
  // left.
  double t = std::max({0., A * (u_trial - A), B * (y_trial - B)}), c_u = 1, c_y = 1, u = 0, y = 0;
  for (unsigned int i = 0; i < 100; ++i)
  {
    c_u = 1 / (1 + t / (A * A));
    c_y = 1 / (1 + t / (B * B));
    u = c_u * u_trial / A;
    y = c_y * y_trial / B;
    const double step = (u * u + y * y - 1) / (2 * (u * u * c_u / (A * A) + y * y * c_y / (B * B)));
    t += step;
    if (!(std::abs(step) > 1e-15 * t))
      break;
  }
  // The normal of the ellipse, softened by c, is what the derivative lacks.
  const double n_u = u / A, n_y = y / B, normal = c_u * n_u * n_u + c_y * n_y * n_y;
  const double cross = -c_u * n_u * c_y * n_y / normal;
  Projection result{cap.start + a * A * u, B * y, c_y};
  result.pp = c_u - c_u * n_u * c_u * n_u / normal;
  result.qq = c_y - c_y * n_y * c_y * n_y / normal;
  result.pq = cross * a;
  result.qp = cross / a;
  return result;
}

template <int dim>
typename DruckerPrager<dim>::Projection
DruckerPrager<dim>::project(const double p, const double q, const Cap &cap) const
{
  const double bulk = this->lambda + 2. / 3. * this->mu;
  const bool before_cap = p <= cap.start;
  const double beyond = (p - cap.start) / (cap.end - cap.start);
  if (before_cap ? q <= cohesion + friction * p : beyond * beyond + q * q / (cap.top * cap.top) <= 1)
    return {p, q, 1., 1., 0., 0., 1., false};
  if (!before_cap)
    return project_on_cap(p, q, cap);
  const double stiffness = 3 * this->mu + bulk * friction * friction;
  const double flow = (q - cohesion - friction * p) / stiffness, q_cone = q - 3 * this->mu * flow;
  if (q_cone < 0)
    return {-cohesion / friction, 0., 0.}; // the tip of the cone
  if (p + bulk * friction * flow > cap.start)
    return {cap.start, cap.top, cap.top / q}; // where cone and cap meet
  Projection result{p + bulk * friction * flow, q_cone, q_cone / q};
  result.pp = 1 - bulk * friction * friction / stiffness;
  result.pq = bulk * friction / stiffness;
  result.qp = 3 * this->mu * friction / stiffness;
  result.qq = 1 - 3 * this->mu / stiffness;
  return result;
}

template <int dim>
std::size_t DruckerPrager<dim>::update(const Inputs<dim> &in, const Outputs<dim> &out) const
{
  using Strain = dealii::SymmetricTensor<2, dim>;
  constexpr unsigned int n_strain = dim * dim;
  const unsigned int n = n_history();
  const double mu = this->mu, bulk = this->lambda + 2. / 3. * mu;
  for (std::size_t point = 0; point < in.n_points; ++point)
  {
    const dealii::Tensor<2, dim> &F = in.deformation_gradient[point];
    const double J = dealii::determinant(F), *old = in.history_old + point * n;
    if (!is_admissible(J))
      return point;
    dealii::Tensor<2, dim> G;
    for (unsigned int i = 0; i < n_strain; ++i)
      G[i / dim][i % dim] = old[i];
    const double det_G = dealii::determinant(G);
    if (!is_admissible(J * det_G))
      return point;
    const LogarithmicStrain<dim> trial(F * G, J * det_G);
    const double zz = dim == 2 ? std::log(old[4]) : 0., volume = std::log(J * det_G) + zz;
    Strain s = 2 * mu * trial.strain; // the deviator
    for (unsigned int i = 0; i < dim; ++i)
      s[i][i] -= 2 * mu / 3 * volume;
    const double s_zz = dim == 2 ? 2 * mu * (zz - volume / 3) : 0.;
    const double p_trial = -bulk * volume, q_trial = std::sqrt(1.5 * (s * s + s_zz * s_zz));
    const Projection at = project(p_trial, q_trial, cap_after(old[n - 1]));
    const Strain one = dealii::unit_symmetric_tensor<dim>(), T = at.ratio * s - at.p * one;

    if (out.stress)
      out.stress[point] = trial.stress(T);
    if (out.tangent)
    {
      dealii::SymmetricTensor<4, dim> modulus =
          isotropic_modulus<dim>(bulk * at.pp - 2. / 3. * mu * at.ratio, mu * at.ratio);
      if (at.flows && q_trial > 0)
      {
        const Strain along = s / q_trial;
        modulus += 3 * mu * (at.qq - at.ratio) * dealii::outer_product(along, along) -
                   3 * mu * at.pq * dealii::outer_product(one, along) -
                   bulk * at.qp * dealii::outer_product(along, one);
      }
      out.tangent[point] = trial.modulus(T, modulus);
    }
    if (dim == 2 && out.out_of_plane_stress)
      out.out_of_plane_stress[point] = at.ratio * s_zz - at.p;
    if (out.energy)
      out.energy[point] = at.p * at.p / (2 * bulk) + at.q * at.q / (6 * mu);
    const double shear = (q_trial - at.q) / (3 * mu), compaction = (p_trial - at.p) / bulk;
    if (out.dissipation)
      out.dissipation[point] = at.flows ? std::max(0., at.q * shear + at.p * compaction) : 0.;
    if (out.history_new)
    {
      double *fresh = out.history_new + point * n;
      std::copy(old, old + n, fresh);
      if (!at.flows)
        continue;
      const Strain D = (1 - at.ratio) / (2 * mu) * s - compaction / 3 * one;
      G = trial.relaxed(G, D);
      for (unsigned int i = 0; i < n_strain; ++i)
        fresh[i] = G[i / dim][i % dim];
      if (dim == 2)
        fresh[4] = old[4] * std::exp(compaction / 3 - (1 - at.ratio) / (2 * mu) * s_zz);
      fresh[n - 3] += shear;
      fresh[n - 2] += compaction;
      fresh[n - 1] += std::max(0., compaction);
    }
  }
  return in.n_points;
}

template class DruckerPrager<2>;
template class DruckerPrager<3>;

namespace
{
[[maybe_unused]] const bool registered = register_law<DruckerPrager>(
    "drucker_prager", "Powder or soil: Drucker-Prager plasticity with an elliptic cap, associated.");
}
} // namespace softgrain::constitutive
