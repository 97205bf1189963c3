// SPDX-License-Identifier: LGPL-2.1-or-later
// The points in the state of MpmModel. In a checkpoint they stand by id, whoever owns them.
#include <softgrain/base/exceptions.h>
#include <softgrain/model/state_file.h>
#include <softgrain/mpm/body/point_store.h>
#include <softgrain/mpm/model/mpm_model.h>

#include <algorithm>
#include <numeric>
#include <optional>

namespace softgrain::mpm
{
namespace
{
/// The points of a list, which stand body after body and by their numbers in the body: which of them are
/// here, and how a writer gets what they carry.
class PointLists
{
public:
  /// @param of_all the points of all are listed, and the first owner gets them; else those that lie here
  PointLists(const std::vector<Body<2>> &bodies, const BodyShare &share, const bool of_all)
      : bodies(bodies), share(share), of_all(of_all), point_of(bodies.size())
  {
    for (const Body<2> &body : bodies)
    {
      begin_of.push_back(n_points);
      const bool listed = of_all ? share.mine(body.index) : share.holds(body.index);
      if (listed || of_all)
        n_points += body.n_points;
      if (!listed)
        continue;
      point_of[body.index].resize(body.n_points);
      for (unsigned int p = 0; p < body.points.size(); ++p)
        point_of[body.index][body.points.number(p)] = p;
    }
    begin_of.push_back(n_points);
  }

  /// @param put writes @p width numbers of point @p p of a body from a place on. All owners call it when the
  /// list is of all.
  template <class Put>
  void write(StateWriter &out, const std::string &name, const unsigned int width, const Put &put) const
  {
    out.write_rows(name, n_points, width,
                   [&](const std::size_t begin, const std::size_t end, double *const rows)
                   {
                     if (of_all && !share.exchange.alone())
                       std::fill(rows, rows + (end - begin) * width, 0.);
                     fill(begin, end, width, put, rows);
                     if (of_all)
                       share.exchange.join_at_first(rows, (end - begin) * width);
                   });
  }

private:
  template <class Put>
  void fill(const std::size_t begin,
            const std::size_t end,
            const unsigned int width,
            const Put &put,
            double *const rows) const
  {
    std::optional<Exchange::OwnWork> own;
    if (of_all)
      own.emplace(share.exchange);
    std::size_t b = std::upper_bound(begin_of.begin(), begin_of.end(), begin) - begin_of.begin() - 1;
    for (; b < bodies.size() && begin_of[b] < end; ++b)
      if (!point_of[b].empty())
        for (std::size_t row = std::max(begin, begin_of[b]); row < std::min(end, begin_of[b + 1]); ++row)
          put(bodies[b], point_of[b][row - begin_of[b]], rows + (row - begin) * width);
  }

  const std::vector<Body<2>> &bodies;
  const BodyShare &share;
  const bool of_all;
  std::vector<std::vector<unsigned int>> point_of; ///< of every body, by number; empty: it is not here
  std::vector<std::size_t> begin_of;               ///< of every body in the list, and the end
  std::size_t n_points = 0;
};

/// Which points of a list in a file belong here, and their places.
struct PointsHere
{
  std::vector<std::size_t> row;
  std::vector<unsigned int> body;
  std::vector<dealii::Point<2>> place;
};

/// Shows @p take those rows of a list that belong here: their count, their numbers.
template <class Take>
void read_here(const StateReader &in,
               const std::string &name,
               const std::size_t n_points,
               const unsigned int width,
               const std::vector<std::size_t> &here,
               const Take &take)
{
  std::size_t k = 0;
  in.read_rows(name, n_points, width,
               [&](const std::size_t begin, const std::size_t end, const double *const rows)
               {
                 for (; k < here.size() && here[k] < end; ++k)
                   take(k, rows + (here[k] - begin) * width);
               });
}

/// @param n_of_body how many points of each body the list has, one body after the other
PointsHere
find_points(const StateReader &in, const BodyShare &share, const std::vector<std::size_t> &n_of_body)
{
  const std::size_t n_points = std::accumulate(n_of_body.begin(), n_of_body.end(), std::size_t(0));
  PointsHere here;
  unsigned int body = 0;
  std::size_t end_of_body = n_of_body.empty() ? 0 : n_of_body[0];
  in.read_rows("mpm/points/body", n_points, 1,
               [&](const std::size_t begin, const std::size_t end, const double *const bodies)
               {
                 for (std::size_t p = begin; p < end; ++p)
                 {
                   while (p >= end_of_body)
                     end_of_body += n_of_body[++body];
                   if (bodies[p - begin] != body)
                     in.refuse("mpm/points/body",
                               "point " + std::to_string(p) + " is not of body " + std::to_string(body));
                   if (!share.holds(body))
                     continue;
                   here.row.push_back(p);
                   here.body.push_back(body);
                 }
               });
  here.place.resize(here.row.size());
  read_here(in, "mpm/points/position", n_points, 2, here.row,
            [&here](const std::size_t k, const double *const numbers)
            { here.place[k] = dealii::Point<2>(numbers[0], numbers[1]); });
  return here;
}
} // namespace

void MpmModel::save_points(StateWriter &out, const bool of_all) const
{
  const PointLists lists(state.bodies, work.share, of_all);
  lists.write(out, "mpm/points/position", 2,
              [](const Body<2> &body, const unsigned int p, double *const numbers)
              { std::copy_n(body.points[p].position().begin_raw(), 2, numbers); });
  for (const PointSlotDescription &slot : state.points->layout().slots())
    lists.write(out, "mpm/points/" + slot.name, slot.n_components,
                [&slot](const Body<2> &body, const unsigned int p, double *const numbers)
                { std::copy_n(body.points[p].data(slot.slot), slot.n_components, numbers); });
}

void MpmModel::load_points(const StateReader &in, const bool of_all)
{
  PointStore<2> &store = *state.points;
  std::vector<std::size_t> n_of_body;
  for (const Body<2> &body : state.bodies)
    n_of_body.push_back(of_all || work.share.holds(body.index) ? body.n_points : 0);
  const std::size_t expected = std::accumulate(n_of_body.begin(), n_of_body.end(), std::size_t(0));
  std::vector<std::size_t> here;
  std::vector<PointStore<2>::Handle> handles;
  {
    PointsHere found = find_points(in, work.share, n_of_body);
    // A run that laid grids anew may go on as one that does not.
    if (std::all_of(found.place.begin(), found.place.end(),
                    [&](const dealii::Point<2> &place)
                    { return store.covers(problem.lattice->cell_of(place)); }))
      store.clear();
    else
      store.cover_all();
    store.reserve(found.row.size());
    for (std::size_t k = 0; k < found.row.size(); ++k)
      handles.push_back(store.add(found.place[k], found.body[k]));
    here = std::move(found.row);
  }
  for (const PointSlotDescription &slot : store.layout().slots())
  {
    read_here(in, "mpm/points/" + slot.name, expected, slot.n_components, here,
              [&](const std::size_t k, const double *const numbers)
              {
                auto point = store(handles[k]);
                std::copy_n(numbers, slot.n_components, point.data(slot.slot));
              });
  }
}
} // namespace softgrain::mpm
