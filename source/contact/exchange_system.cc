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

double ExchangeSystem::row_times(const unsigned int row,
                                 const Row kind,
                                 const double side,
                                 const Vector &x,
                                 const std::vector<int> *const at) const
{
  const auto value = [&](const unsigned int i) { return x[at == nullptr ? static_cast<int>(i) : (*at)[i]]; };
  if (kind == Row::no_impulse)
    return value(row);
  if (kind == Row::edge)
    return value(row) - side * value(row - 1);
  double sum = 0.;
  for (Matrix::InnerIterator entry(W, row); entry; ++entry)
    sum += entry.value() * value(entry.col());
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
    base = std::make_unique<ActiveSystem>(n_closed, n_entries, false);
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
  keep_slots();
  return true;
}

void ExchangeSystem::keep_slots()
{
  const int no_slot = n_closed + most_updates;
  slot.assign(W.rows(), no_slot);
  component.clear();
  part_start.assign(1, 0);
  part_slot.clear();
  part_value.clear();
  for (int row = 0; row < W.rows(); ++row)
  {
    if (place[row] >= 0)
    {
      slot[row] = place[row];
      component.push_back(row);
    }
    for (Matrix::InnerIterator entry(W, row); entry; ++entry)
      if (place[entry.col()] >= 0)
      {
        part_slot.push_back(place[entry.col()]);
        part_value.push_back(entry.value());
      }
    part_start.push_back(part_slot.size());
  }
  of_base.clear();
  base_number.assign(W.rows(), -1);
  columns.resize(no_slot + 1, most_updates);
}

// The column of the inverse of the system as it was when factors were made. A third of the rows come again.
const ExchangeSystem::Vector &ExchangeSystem::base_column(const unsigned int row)
{
  if (base_number[row] >= 0)
    return of_base[base_number[row]];
  base_number[row] = of_base.size();
  of_base.push_back(Vector::Zero(columns.rows()));
  Vector &column = of_base.back();
  if (place[row] < 0)
    column[slot[row]] = 1.;
  if (!base)
    return column;
  Vector b = Vector::Zero(n_closed);
  if (place[row] >= 0)
    b[place[row]] = 1.;
  else
    // An impulse where there was none acts on all that is closed.
    for (Matrix::InnerIterator entry(W, row); entry; ++entry)
      if (place[entry.col()] >= 0 && base_kind[entry.col()] == Row::no_speed)
        b[place[entry.col()]] = -entry.value();
  column.head(n_closed) = base->solve_with_factors(b);
  return column;
}

// Every update takes off its own column, times what its row makes of the column as it is by then: one after
// the other, for all at once would lose digits where W has rigid modes.
ExchangeSystem::Vector ExchangeSystem::column_of_inverse(const unsigned int row)
{
  Vector column = base_column(row);
  for (unsigned int i = 0; i < updates.size(); ++i)
  {
    const Update &update = updates[i];
    const double now =
        row_times(update.row, update.kind, update.side, column, &slot) - (update.row == row ? 1. : 0.);
    if (now != 0.)
      column -= now / update.pivot * columns.col(i);
  }
  return column;
}

// Of rows with w = 0 nothing is to be known.
void ExchangeSystem::add_to_speeds(const Vector &column, const double (&factor)[2])
{
  const unsigned int n_rows = W.rows();
  for (unsigned int row = 0; row < n_rows; ++row)
    if (kind_of(row) == Row::no_speed)
      w[0][row] = w[1][row] = 0.;
    else
    {
      double sum = 0.;
      for (int k = part_start[row]; k < part_start[row + 1]; ++k)
        sum += part_value[k] * column[part_slot[k]];
      w[0][row] += factor[0] * sum;
      w[1][row] += factor[1] * sum;
    }
  for (unsigned int s = n_closed; s < component.size(); ++s)
    if (column[s] != 0.)
      for (Matrix::InnerIterator entry(W, component[s]); entry; ++entry) // W is symmetric
        if (kind_of(entry.col()) != Row::no_speed)
          for (unsigned int part = 0; part < 2; ++part)
            w[part][entry.col()] += factor[part] * column[s] * entry.value();
}

bool ExchangeSystem::replace(const unsigned int row)
{
  if (slot[row] == columns.rows() - 1)
  {
    slot[row] = component.size();
    component.push_back(row);
  }
  Update update{row, kind_of(row), side_of(row / 2), 0.};
  const unsigned int n = updates.size();
  columns.col(n) = column_of_inverse(row);
  const Vector column = columns.col(n);
  update.pivot = row_times(row, update.kind, update.side, column, &slot);
  if (!(std::abs(update.pivot) > 1e-11 * column.lpNorm<Eigen::Infinity>()))
    return false;
  double factor[2];
  for (unsigned int part = 0; part < 2; ++part)
  {
    const double missing = right_side(row, part) - row_times(row, update.kind, update.side, P[part], nullptr);
    factor[part] = missing / update.pivot;
    for (unsigned int s = 0; s < component.size(); ++s)
      P[part][component[s]] += factor[part] * column[s];
  }
  add_to_speeds(column, factor);
  updates.push_back(update);
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
