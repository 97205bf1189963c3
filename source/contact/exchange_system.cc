// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/contact/exchange_system.h>

#include <cmath>
#include <utility>

namespace softgrain::contact
{
namespace
{
constexpr unsigned int most_updates = 60; ///< after which new factors are cheaper
} // namespace

ExchangeSystem::ExchangeSystem(Matrix matrix) : W(std::move(matrix)) {}

void ExchangeSystem::start(std::vector<ContactState> initial,
                           const Vector &friction,
                           const Vector &velocity,
                           const Vector &change)
{
  states = std::move(initial);
  mu = friction;
  q[0] = velocity;
  q[1] = change;
}

ExchangeSystem::Row ExchangeSystem::kind_of(const unsigned int row) const
{
  const ContactState state = states[row / 2];
  if (state == ContactState::open)
    return Row::no_impulse;
  return row % 2 == 0 || state == ContactState::sticks ? Row::no_speed : Row::edge;
}

double ExchangeSystem::side_of(const unsigned int contact) const
{
  return states[contact] == ContactState::slides_down ? mu[contact] : -mu[contact];
}

double
ExchangeSystem::row_times(const unsigned int row, const Row kind, const double side, const Vector &x) const
{
  if (kind == Row::no_impulse)
    return x[row];
  if (kind == Row::edge)
    return x[row] - side * x[row - 1];
  double sum = 0.;
  for (Matrix::InnerIterator entry(W, row); entry; ++entry)
    sum += entry.value() * x[entry.col()];
  return sum;
}

double ExchangeSystem::right_side(const unsigned int row, const unsigned int part) const
{
  return kind_of(row) == Row::no_speed ? -q[part][row] : 0.;
}

bool ExchangeSystem::factorise()
{
  updates.clear();
  place.assign(W.rows(), -1);
  base_kind.resize(W.rows());
  n_closed = 0;
  std::size_t n_entries = 0;
  for (int row = 0; row < W.rows(); ++row)
  {
    base_kind[row] = kind_of(row);
    if (base_kind[row] == Row::no_impulse)
      continue;
    place[row] = n_closed++;
    n_entries += base_kind[row] == Row::edge ? 2 : W.outerIndexPtr()[row + 1] - W.outerIndexPtr()[row];
  }
  for (Vector &part : P)
    part = Vector::Zero(W.rows());
  base.reset();
  if (n_closed > 0)
  {
    base = std::make_unique<ActiveSystem>(n_closed, n_entries);
    Vector b[2] = {Vector(n_closed), Vector(n_closed)};
    for (int row = 0; row < W.rows(); ++row)
    {
      if (place[row] < 0)
        continue;
      if (base_kind[row] == Row::edge)
      {
        base->add(place[row], place[row], 1.);
        base->add(place[row], place[row - 1], -side_of(row / 2));
      }
      else
        for (Matrix::InnerIterator entry(W, row); entry; ++entry)
          if (place[entry.col()] >= 0)
            base->add(place[row], place[entry.col()], entry.value());
      for (unsigned int part = 0; part < 2; ++part)
        b[part][place[row]] = right_side(row, part);
    }
    if (!base->factorise_general())
      return false;
    for (unsigned int part = 0; part < 2; ++part)
    {
      const Vector x = base->solve_with_factors(b[part]);
      if (!x.allFinite())
        return false;
      for (int row = 0; row < W.rows(); ++row)
        if (place[row] >= 0)
          P[part][row] = x[place[row]];
    }
  }
  for (unsigned int part = 0; part < 2; ++part)
    w[part] = W * P[part] + q[part];
  return true;
}

// The column of the inverse of the system as it was when factors were made.
ExchangeSystem::Vector ExchangeSystem::solve_base(const unsigned int row) const
{
  Vector column = Vector::Zero(W.rows());
  Vector b = Vector::Zero(n_closed);
  if (place[row] >= 0)
    b[place[row]] = 1.;
  else
  {
    // An impulse where there was none acts on all that is closed.
    column[row] = 1.;
    for (Matrix::InnerIterator entry(W, row); entry; ++entry)
      if (place[entry.col()] >= 0 && base_kind[entry.col()] == Row::no_speed)
        b[place[entry.col()]] = -entry.value();
  }
  if (!base)
    return column;
  const Vector x = base->solve_with_factors(b);
  for (int i = 0; i < W.rows(); ++i)
    if (place[i] >= 0)
      column[i] = x[place[i]];
  return column;
}

ExchangeSystem::Vector ExchangeSystem::column_of_inverse(const unsigned int row) const
{
  Vector column = solve_base(row);
  for (const Update &update : updates)
  {
    const double now =
        row_times(update.row, update.kind, update.side, column) - (update.row == row ? 1. : 0.);
    if (now != 0.)
      column -= now / update.pivot * update.column;
  }
  return column;
}

bool ExchangeSystem::replace(const unsigned int row)
{
  Update update{row, kind_of(row), side_of(row / 2), 0., column_of_inverse(row)};
  update.pivot = row_times(row, update.kind, update.side, update.column);
  if (!(std::abs(update.pivot) > 1e-11 * update.column.lpNorm<Eigen::Infinity>()))
    return false;
  const Vector of_column = W * update.column;
  for (unsigned int part = 0; part < 2; ++part)
  {
    const double missing = right_side(row, part) - row_times(row, update.kind, update.side, P[part]);
    P[part] += missing / update.pivot * update.column;
    w[part] += missing / update.pivot * of_column;
  }
  updates.push_back(std::move(update));
  return true;
}

bool ExchangeSystem::exchange(const unsigned int contact, const ContactState to)
{
  const Row before = kind_of(2 * contact);
  states[contact] = to;
  if (updates.size() + 2 > most_updates)
    return factorise();
  if ((kind_of(2 * contact) != before && !replace(2 * contact)) || !replace(2 * contact + 1))
    return factorise();
  return P[0].allFinite() && P[1].allFinite();
}
} // namespace softgrain::contact
