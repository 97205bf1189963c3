// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/interruption.h>
#include <softgrain/contact/contact_path.h>
#include <softgrain/contact/residual.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace softgrain::contact
{
namespace
{
using Matrix = ExchangeSystem::Matrix;
using Vector = Eigen::VectorXd;

/// W of @p selected, times a factor.
Matrix reduced(const Matrix &W, const std::vector<unsigned int> &selected, const double factor)
{
  std::vector<int> local(W.rows(), -1);
  for (unsigned int k = 0; k < selected.size(); ++k)
    for (unsigned int c = 0; c < 2; ++c)
      local[2 * selected[k] + c] = 2 * k + c;
  std::vector<Eigen::Triplet<double>> entries;
  for (int row = 0; row < W.rows(); ++row)
    if (local[row] >= 0)
      for (Matrix::InnerIterator entry(W, row); entry; ++entry)
        if (local[entry.col()] >= 0)
          entries.emplace_back(local[row], local[entry.col()], factor * entry.value());
  Matrix result(2 * selected.size(), 2 * selected.size());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

double median_compliance(const std::vector<double> &compliance, const std::vector<unsigned int> &selected)
{
  std::vector<double> values;
  for (const unsigned int contact : selected)
    values.push_back(compliance[contact]);
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}
} // namespace

ContactPath::ContactPath(const Matrix &W_all,
                         const Problem &problem,
                         const std::vector<double> &compliance,
                         const std::vector<unsigned int> &selected,
                         const std::vector<double> &impulses,
                         const double margin,
                         const double decades,
                         const unsigned int seed)
    : selected(selected)
    , mu(selected.size())
    , speed(approach_speed(problem, compliance))
    , softness(median_compliance(compliance, selected))
    , unit(speed / softness)
    , system(reduced(W_all, selected, 1. / softness))
{
  const unsigned int n = selected.size();
  Vector P = Vector::Zero(2 * n), q(2 * n);
  std::vector<State> states(n, State::open);
  for (unsigned int k = 0; k < n; ++k)
  {
    const unsigned int i = selected[k];
    mu[k] = problem.friction_of(i);
    q[2 * k] = problem.free_velocity[2 * i] / speed;
    q[2 * k + 1] = problem.free_velocity[2 * i + 1] / speed;
    if (!(impulses[2 * i] > 0.))
      continue;
    P[2 * k] = impulses[2 * i] / unit;
    P[2 * k + 1] = impulses[2 * i + 1] / unit;
    states[k] = State::sticks;
    if (!on_edge_of_cone(mu[k], P[2 * k], std::abs(P[2 * k + 1])))
      continue;
    states[k] = P[2 * k + 1] >= 0. ? State::slides_down : State::slides_up;
    P[2 * k + 1] = std::copysign(mu[k] * P[2 * k], P[2 * k + 1]);
  }
  // The problem that these impulses solve: q such that w is what the states say.
  const Vector of_impulses = system.times(P);
  Vector w = of_impulses + q;
  unsigned int random = seed;
  for (unsigned int k = 0; k < n; ++k)
  {
    random = random * 1664525u + 1013904223u; // any numbers, the same on every machine
    const double least = margin * std::pow(10., decades * (random >> 8) / double(1u << 24));
    double &normal = w[2 * k], &tangential = w[2 * k + 1];
    normal = states[k] == State::open ? std::max(normal, least) : 0.;
    if (states[k] == State::sticks)
      tangential = 0.;
    else if (states[k] == State::slides_down)
      tangential = std::min(tangential, -least);
    else if (states[k] == State::slides_up)
      tangential = std::max(tangential, least);
  }
  const Vector start = w - of_impulses;
  system.start(std::move(states), mu, start, q - start);
}

std::vector<double> ContactPath::impulses(const unsigned int n_contacts) const
{
  std::vector<double> P(2 * n_contacts, 0.);
  for (unsigned int k = 0; k < selected.size(); ++k)
    if (system.state(k) != State::open)
    {
      P[2 * selected[k]] = unit * std::max(0., system.impulse(2 * k, t));
      P[2 * selected[k] + 1] = unit * system.impulse(2 * k + 1, t);
    }
  return P;
}

ContactPath::Line ContactPath::line(const unsigned int k, const Condition what) const
{
  const unsigned int n = 2 * k, s = n + 1;
  const auto cone = [&](const double side) -> Line
  {
    return {mu[k] * system.impulse(n, t) - side * system.impulse(s, t),
            mu[k] * system.impulse_slope(n) - side * system.impulse_slope(s)};
  };
  switch (what)
  {
  case Condition::parts:
    return {system.speed(n, t), system.speed_slope(n)};
  case Condition::upper_edge:
    return cone(1.);
  case Condition::lower_edge:
    return cone(-1.);
  case Condition::pressed:
    return {system.impulse(n, t), system.impulse_slope(n)};
  default:
    const double side = system.state(k) == State::slides_up ? 1. : -1.;
    return {side * system.speed(s, t), side * system.speed_slope(s)};
  }
}

void ContactPath::look_at(const unsigned int k, const Condition what, Event &nearest) const
{
  const Line now = line(k, what);
  const double slope = direction * now.slope;
  if (slope >= 0. || (has_grown && k == grown_contact && what == grown && std::abs(now.value) < 1e-9))
    return;
  const double way = std::max(0., now.value) / -slope;
  if (way < nearest.way)
    nearest = {k, what, way};
}

ContactPath::Event ContactPath::next_event() const
{
  Event nearest;
  for (unsigned int k = 0; k < selected.size(); ++k)
    switch (system.state(k))
    {
    case State::open:
      look_at(k, Condition::parts, nearest);
      break;
    case State::sticks:
      look_at(k, Condition::upper_edge, nearest);
      look_at(k, Condition::lower_edge, nearest);
      break;
    default:
      look_at(k, Condition::pressed, nearest);
      look_at(k, Condition::slides, nearest);
    }
  return nearest;
}

// What became 0 stays so, and what it excludes may grow.
bool ContactPath::exchange(const Event &event)
{
  const unsigned int k = event.contact;
  State next;
  switch (event.what)
  {
  case Condition::parts:
    next = system.speed(2 * k + 1, t) <= 0. ? State::slides_down : State::slides_up;
    grown = Condition::pressed;
    break;
  case Condition::upper_edge:
    next = State::slides_down;
    grown = Condition::slides;
    break;
  case Condition::lower_edge:
    next = State::slides_up;
    grown = Condition::slides;
    break;
  case Condition::pressed:
    next = State::open;
    grown = Condition::parts;
    break;
  default:
    grown = system.state(k) == State::slides_down ? Condition::upper_edge : Condition::lower_edge;
    next = State::sticks;
  }
  has_grown = true;
  grown_contact = k;
  if (!system.exchange(k, next))
    return false;
  direction = line(k, grown).slope >= 0. ? 1. : -1.;
  return true;
}

bool ContactPath::follow(const unsigned int most)
{
  if (!system.factorise())
    return false;
  Event first;
  std::vector<State> first_states;
  double first_t = 0.;
  for (exchanges = 0; exchanges < most; ++exchanges)
  {
    if (exchanges % 100 == 0)
      stop_if_interrupted();
    const Event event = next_event();
    const double next = t + direction * event.way;
    if (direction > 0. && next >= 1.)
    {
      t = 1.;
      return true;
    }
    if (!std::isfinite(next))
      return false;
    t = next;
    if (exchanges == 0)
    {
      first = event;
      first_states = system.all_states();
      first_t = t;
    }
    else if (event.contact == first.contact && event.what == first.what && std::abs(t - first_t) < 1e-9 &&
             system.all_states() == first_states)
      return false; // a closed loop: it comes by where it began
    if (!exchange(event))
      return false;
  }
  return false;
}
} // namespace softgrain::contact
