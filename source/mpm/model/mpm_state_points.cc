// SPDX-License-Identifier: LGPL-2.1-or-later
// The points in the state of MpmModel. In a checkpoint they stand by id, whichever rank has them.
#include <softgrain/base/exceptions.h>
#include <softgrain/model/state_file.h>
#include <softgrain/mpm/body/point_store.h>
#include <softgrain/mpm/model/mpm_model.h>

#include <algorithm>

namespace softgrain::mpm
{
namespace
{
/// Lists of numbers of points, as many of each: what a rank writes, and what it must know of others for that.
class PointLists
{
public:
  /// @param of_all the first rank gets the points of all others; else every rank lists those that lie with it
  PointLists(const std::vector<Body<2>> &bodies, const BodyShare &share, const bool of_all)
      : bodies(bodies), share(share), of_all(of_all)
  {
    for (const Body<2> &body : bodies)
    {
      begin.push_back(room);
      if (is_listed(body) || (of_all && share.ranks.first()))
        room += body.n_points;
    }
  }

  /// @param put writes @p n_components numbers of point @p p of a body from a place on. All ranks call it
  /// when the list is of all.
  template <class Put>
  std::vector<double> make(const unsigned int n_components, const Put &put) const
  {
    std::vector<double> numbers;
    const auto make_own = [&]()
    {
      numbers.resize(room * n_components);
      for (const Body<2> &body : bodies)
        if (is_listed(body))
          for (unsigned int p = 0; p < body.points.size(); ++p)
            put(body, p, &numbers[(begin[body.index] + body.points.number(p)) * n_components]);
    };
    if (!of_all)
    {
      make_own();
      return numbers;
    }
    share.ranks.together(make_own);
    std::vector<Ranks::Piece> pieces;
    for (const Body<2> &body : bodies)
      if (share.ranks.first() || is_listed(body))
        pieces.push_back({share.owner(body.index), numbers.data() + begin[body.index] * n_components,
                          static_cast<std::size_t>(body.n_points) * n_components});
    share.ranks.bring(pieces);
    return numbers;
  }

private:
  bool is_listed(const Body<2> &body) const
  {
    return of_all ? share.mine(body.index) : share.holds(body.index);
  }

  const std::vector<Body<2>> &bodies;
  const BodyShare &share;
  const bool of_all;
  std::vector<std::size_t> begin; ///< of every body in the list of this rank
  std::size_t room = 0;
};
} // namespace

void MpmModel::save_points(StateWriter &out, const bool of_all) const
{
  const PointLists lists(state.bodies, work.share, of_all);
  out.write("mpm/points/position",
            lists.make(2, [](const Body<2> &body, const unsigned int p, double *const numbers)
                       { std::copy_n(body.points[p].position().begin_raw(), 2, numbers); }));
  for (const PointSlotDescription &slot : state.points->layout().slots())
    out.write("mpm/points/" + slot.name,
              lists.make(slot.n_components,
                         [&slot](const Body<2> &body, const unsigned int p, double *numbers)
                         { std::copy_n(body.points[p].data(slot.slot), slot.n_components, numbers); }));
}

void MpmModel::load_points(const StateReader &in, const bool of_all)
{
  PointStore<2> &store = *state.points;
  std::size_t expected = 0;
  for (const Body<2> &body : state.bodies)
    if (of_all || work.share.holds(body.index))
      expected += body.n_points;
  // Of a list with the points of all, those that belong here, by their number in it.
  std::vector<std::size_t> here;
  std::vector<PointStore<2>::Handle> handles;
  {
    const std::vector<double> positions = in.read_doubles("mpm/points/position"),
                              bodies = in.read_doubles("mpm/points/body");
    if (positions.size() != 2 * expected || bodies.size() != expected)
      throw InputError("the checkpoint was made with another number of material points");
    const auto place = [&positions](const std::size_t p)
    { return dealii::Point<2>(positions[2 * p], positions[2 * p + 1]); };
    bool all_covered = true;
    for (std::size_t p = 0; p < expected; ++p)
      if (work.share.holds(static_cast<unsigned int>(bodies[p])))
      {
        here.push_back(p);
        all_covered = all_covered && store.covers(problem.lattice->cell_of(place(p)));
      }
    // A run that laid grids anew may go on as one that does not.
    if (all_covered)
      store.clear();
    else
      store.cover_all();
    store.reserve(here.size());
    for (const std::size_t p : here)
      handles.push_back(store.add(place(p), static_cast<unsigned int>(bodies[p])));
  }
  for (const PointSlotDescription &slot : store.layout().slots())
  {
    const std::vector<double> values = in.read_doubles("mpm/points/" + slot.name);
    if (values.size() != expected * slot.n_components)
      throw InputError("the checkpoint was made with other settings: its points have another '" + slot.name +
                       "'");
    for (std::size_t p = 0; p < here.size(); ++p)
    {
      auto point = store(handles[p]);
      std::copy_n(&values[here[p] * slot.n_components], slot.n_components, point.data(slot.slot));
    }
  }
}
} // namespace softgrain::mpm
