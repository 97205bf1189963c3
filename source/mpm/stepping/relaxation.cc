// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/relaxation.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
constexpr double most = 1e3;     ///< resistance, beyond which bodies hardly move in a step
constexpr double weakest = 1e-3; ///< resistance, over what was set
/// Factor of resistance after a step that was refused. Free walls go as far in a step as it lets them: what
/// is too much costs as many more steps on the way to the bodies.
constexpr double rise_at_rest = 10., rise_with_free_walls = 3.;

/// Held steps without a better balance, after which bodies that go back and forth are in a circle.
constexpr unsigned int most_in_vain = 12;

/// Displacements of the nodes of all bodies [m].
std::vector<Eigen::VectorXd> displacements(const State &state)
{
  std::vector<Eigen::VectorXd> all;
  for (const Body<2> &body : state.bodies)
    all.push_back(body.displacement);
  return all;
}

/// Cosine of the angle between two ways; 1 when there is none.
double cosine(const std::vector<Eigen::VectorXd> &a, const std::vector<Eigen::VectorXd> &b)
{
  double product = 0., square_a = 0., square_b = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
  {
    product += a[i].dot(b[i]);
    square_a += a[i].squaredNorm();
    square_b += b[i].squaredNorm();
  }
  return square_a * square_b > 0. ? product / std::sqrt(square_a * square_b) : 1.;
}

bool is_free(const Wall &wall)
{
  return !wall.prescribed() || wall.slides_freely();
}
} // namespace

Relaxation::Relaxation(const Problem &problem, const State &state, const double dt)
    : next{dt, true, problem.settings.regularisation}
    , wanted(problem.settings.regularisation)
    , rise(std::any_of(state.walls.begin(), state.walls.end(), is_free) ? rise_with_free_walls : rise_at_rest)
    , least(weakest * wanted)
    , place(displacements(state))
{
}

bool Relaxation::refused()
{
  const bool went_ahead = next.ahead > 0.;
  look_ahead(false);
  way.clear();
  next.guess = nullptr; // it may be what failed
  if (went_ahead)
    return true;
  next.regularisation *= rise;
  least = next.regularisation;
  return next.regularisation <= most;
}

void Relaxation::accepted(const StepOutcome &step,
                          const State &state,
                          const double before,
                          const double after,
                          const bool walls_on_their_way)
{
  Vectors now = displacements(state);
  for (unsigned int b = 0; b < now.size(); ++b)
    place[b] = now[b] - place[b];
  turn = way.empty() ? 0. : cosine(place, way);
  way.swap(place);
  place.swap(now);
  // In a cell they also go where it takes them, which is no guess for what they do beside that.
  next.guess = turn > 0. && !state.repeats() ? &way : nullptr;
  look_ahead(next.guess != nullptr && after < 1.5 * before);
  if (walls_on_their_way)
    ease(step);
  else
    resist(step, before, after);
}

void Relaxation::look_ahead(const bool go_on)
{
  const double following = go_on ? 0.5 * (1. + std::sqrt(1. + 4. * sequence * sequence)) : 1.;
  next.ahead = go_on ? (sequence - 1.) / following : 0.;
  sequence = following;
}

// Walls that have not met what bears them go as far as resistance lets them: what a refused step put up is
// taken off again.
void Relaxation::ease(const StepOutcome &step)
{
  if (turn >= -0.3 && step.rows_follow)
    next.regularisation = std::max({0.5 * next.regularisation, least, std::min(next.regularisation, wanted)});
  least = std::max(0.8 * least, weakest * wanted);
}

void Relaxation::resist(const StepOutcome &step, const double before, const double after)
{
  if (after < 0.9 * lowest)
  {
    lowest = after;
    since_lowest = 0;
  }
  else
    ++since_lowest;
  // Back and forth: rows and bodies chase each other. On and on, or slow: what resists has no reason to.
  if (turn < -0.3)
  {
    // In a circle this resistance is too little: it must not fall as far again at once.
    if (since_lowest > most_in_vain)
      least = std::max(least, std::min(3. * next.regularisation, 1.));
    next.regularisation = std::max(next.regularisation, std::min(10. * next.regularisation, 10.));
  }
  else if (step.rows_follow && after > 0.3 * before)
    next.regularisation = std::max(0.1 * next.regularisation, least);
  least = std::max((step.newton_iterations <= 4 ? 0.5 : 0.8) * least, weakest * wanted);
}
} // namespace softgrain::mpm
