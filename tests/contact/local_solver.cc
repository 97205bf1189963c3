// SPDX-License-Identifier: LGPL-2.1-or-later
// One contact: closed forms of every case, and random blocks checked by the conditions themselves, not by the
// solver.
#include <softgrain/contact/local_solver.h>
#include <softgrain/contact/residual.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

using namespace softgrain::contact;

namespace
{
const char *name(const LocalStatus status)
{
  return status == LocalStatus::separated ? "separated"
         : status == LocalStatus::stick   ? "stick"
         : status == LocalStatus::slip    ? "slip"
                                          : "prescribed";
}

template <unsigned int n>
void show(const char *title, const double (&W)[n * n], const double (&q)[n], const double mu)
{
  double P[n];
  const LocalStatus status = solve_local<n>(W, q, mu, P);
  std::cout << title << ": " << name(status);
  for (const double value : P)
    std::cout << ' ' << (value == 0. ? 0. : value);
  std::cout << '\n';
}

/// Worst violation of Signorini and Coulomb, condition by condition, as a velocity over |q| + trace |P|: what
/// rounding of W P alone makes is proportional to that.
template <unsigned int n>
double violation(const double (&W)[n * n], const double (&q)[n], const double mu, const double (&P)[n])
{
  double w[n], trace = 0., speed = 0., slip = 0., friction = 0., power = 0.;
  for (unsigned int c = 0; c < n; ++c)
  {
    w[c] = q[c];
    for (unsigned int d = 0; d < n; ++d)
      w[c] += W[c * n + d] * P[d];
    trace += W[c * n + c] / n;
    speed += q[c] * q[c];
  }
  for (unsigned int c = 1; c < n; ++c)
  {
    slip += w[c] * w[c];
    friction += P[c] * P[c];
    power += w[c] * P[c];
  }
  ::sqrt(speed);
  slip = std::sqrt(slip);
  friction = std::sqrt(friction);
  speed = std::sqrt(speed) + trace * std::sqrt(P[0] * P[0] + friction * friction);
  double worst = std::max({-w[0] / speed, -P[0] * trace / speed, (friction - mu * P[0]) * trace / speed});
  worst = std::max(worst, std::min(std::abs(w[0]), P[0] * trace) / speed);
  // sliding: the friction is mu P_n and its power is -mu P_n |w_t|; min() because a stick has slip = 0
  // instead
  worst = std::max(worst, std::min(slip, std::abs(friction - mu * P[0]) * trace) / speed);
  if (P[0] > 0.)
    worst = std::max(worst, (power + mu * P[0] * slip) / (mu * P[0] + 1e-300) / speed);
  return worst;
}

template <unsigned int n>
void random_blocks(const unsigned int number, const bool singular)
{
  std::mt19937 generator(7 * n + singular);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  double worst = 0., worst_map = 0.;
  unsigned int count[4] = {0, 0, 0, 0};
  for (unsigned int k = 0; k < number; ++k)
  {
    double L[n][n + 2], W[n * n], q[n], P[n], w[n];
    const unsigned int rank = singular ? n - 1 : n + 2;
    for (auto &row : L)
      for (double &value : row)
        value = uniform(generator);
    const double oblique = singular ? 1. : std::pow(10., uniform(generator));
    for (unsigned int c = 0; c < n; ++c)
      for (unsigned int d = 0; d < n; ++d)
      {
        W[c * n + d] = 0.;
        for (unsigned int r = 0; r < rank; ++r)
          W[c * n + d] += L[c][r] * L[d][r] * (c == 0 ? oblique : 1.) * (d == 0 ? oblique : 1.);
      }
    for (double &value : q)
      value = uniform(generator);
    // a singular block may be unable to stop the approach without friction pulling; keep to those that can
    const double mu = singular ? 0.3 * std::abs(uniform(generator)) : std::pow(10., uniform(generator));
    if (singular)
      for (unsigned int c = 1; c < n; ++c)
        if (std::abs(W[c]) > 0.9 * W[0] / 0.3 / std::sqrt(2.))
          q[0] = std::abs(q[0]);
    ++count[static_cast<unsigned int>(solve_local<n>(W, q, mu, P))];
    worst = std::max(worst, violation<n>(W, q, mu, P));
    double trace = 0.;
    for (unsigned int c = 0; c < n; ++c)
    {
      w[c] = q[c];
      for (unsigned int d = 0; d < n; ++d)
        w[c] += W[c * n + d] * P[d];
      trace += W[c * n + c] / n;
    }
    double size = 1.;
    for (const double value : P)
      size += trace * std::abs(value);
    worst_map = std::max(worst_map, natural_map<n>(P, w, mu, trace) / size);
  }
  std::cout << n << " components, " << (singular ? "singular" : "regular")
            << ": worst violation below 1e-9: " << (worst < 1e-9 ? "yes" : "NO")
            << ", natural map below 1e-9: " << (worst_map < 1e-9 ? "yes" : "NO")
            << ", separated stick slip prescribed " << count[0] << ' ' << count[1] << ' ' << count[2] << ' '
            << count[3] << '\n';
}
} // namespace

int main()
{
  std::cout.precision(12);
  show<1>("1D open", {2.}, {0.5}, 0.);
  show<1>("1D closed, P = 0.5 / 2", {2.}, {-0.5}, 0.);
  show<1>("1D prescribed", {0.}, {-0.5}, 0.);
  show<2>("2D open", {2., 0., 0., 4.}, {0.5, 3.}, 0.3);
  show<2>("2D stick, P = (1, -0.25)", {2., 0., 0., 4.}, {-2., 1.}, 0.3);
  show<2>("2D slip, P = (1, -0.2)", {2., 0., 0., 4.}, {-2., 1.}, 0.2);
  show<2>("2D slip the other way, P = (1, 0.2)", {2., 0., 0., 4.}, {-2., -1.}, 0.2);
  // W = [2 1; 1 4]: stick P = -W^-1 q = (9, -4)/7 for q = (-2, 1), slip P_n = 2 / (2 - mu)
  show<2>("2D oblique stick, P = (9, -4)/7", {2., 1., 1., 4.}, {-2., 1.}, 0.5);
  show<2>("2D oblique slip, P = 2/1.7 (1, -0.3)", {2., 1., 1., 4.}, {-2., 1.}, 0.3);
  show<2>("2D prescribed normal", {0., 0., 0., 4.}, {-2., 1.}, 0.3);
  show<2>("2D prescribed tangent, P = (1, -0.3)", {2., 0., 0., 0.}, {-2., 1.}, 0.3);
  show<2>("2D nothing tangential, P = (1, 0)", {2., 0., 0., 0.}, {-2., 0.}, 0.3);
  show<2>("2D no friction, P = (1, 0)", {2., 0., 0., 4.}, {-2., 1.}, 0.);
  // jams to one side: W_nn - mu |W_nt| < 0; slip with P_t < 0 is impossible
  show<2>("2D jamming, P = W^-1 (1, 0) = (25, -12)", {1., 2., 2., 25. / 6.}, {-1., 0.}, 0.5);
  show<3>("3D stick, P = (1, -0.15, -0.2)", {2., 0., 0., 0., 4., 0., 0., 0., 4.}, {-2., 0.6, 0.8}, 0.3);
  show<3>("3D slip, P = (1, -0.12, -0.16)", {2., 0., 0., 0., 4., 0., 0., 0., 4.}, {-2., 0.6, 0.8}, 0.2);
  // anisotropic: with mu P_n = 1 and direction (0.6, 0.8), w_t = -s (0.6, 0.8) and s = 1 give q_t = -w... =
  // (-1.8, -5.6)
  show<3>("3D anisotropic slip, P = (2, 0.6, 0.8)", {1., 0., 0., 0., 2., 0., 0., 0., 6.}, {-2., -1.8, -5.6},
          0.5);
  show<3>("3D prescribed", {0., 0., 0., 0., 4., 0., 0., 0., 4.}, {-2., 0.6, 0.8}, 0.2);
  // block on a slope: impulse of one step of gravity, sticks while tan(theta) < mu, speeds up by g dt (sin -
  // mu cos) after
  for (const double angle : {0.3, std::atan(0.5) - 1e-9, std::atan(0.5) + 1e-9, 0.7})
  {
    const double m = 3., g = 9.81, dt = 1e-3, mu = 0.5;
    const double W[4] = {1. / m, 0., 0., 1. / m},
                 q[2] = {-g * dt * std::cos(angle), g * dt * std::sin(angle)};
    double P[2];
    const auto status = solve_local<2>(W, q, mu, P);
    const double gain = std::sin(angle) - mu * std::cos(angle);
    std::cout << "slope " << angle << ": " << name(status) << ", P_n / (m g dt cos) "
              << P[0] / (m * g * dt * std::cos(angle)) << ", acceleration less theory "
              << std::abs((q[1] + P[1] / m) / dt - (gain > 0. ? g * gain : 0.)) << '\n';
  }
  random_blocks<1>(10000, false);
  random_blocks<2>(200000, false);
  random_blocks<3>(200000, false);
  random_blocks<2>(100000, true);
  random_blocks<3>(100000, true);
}
