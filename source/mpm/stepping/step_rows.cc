// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/share_outlines.h>
#include <softgrain/mpm/contact/share_rows.h>
#include <softgrain/mpm/stepping/step_rows.h>

#include <deal.II/base/timer.h>

#include <algorithm>
#include <utility>

namespace softgrain::mpm
{
namespace
{
/// What a search for contact reads; it refers to all that is handed in.
ContactScene<2> contact_scene(const Problem &problem,
                              const State &state,
                              const Workspace &work,
                              const std::vector<WallMotion<2>> &motion,
                              const double dt,
                              const std::vector<Eigen::VectorXd> *increment,
                              const double share,
                              const std::optional<CellMotion> &cell)
{
  ContactScene<2> scene{state.bodies,
                        work.drive,
                        motion,
                        problem.pairs,
                        dt,
                        problem.lattice->cell_size(),
                        increment,
                        share,
                        problem.places_are_free(),
                        problem.places_slide(),
                        problem.subgrid(),
                        problem.pairs.adhere() ? state.adhesion.reach() : 0.};
  scene.obstacles = state.obstacles.empty() ? nullptr : &state.obstacles;
  scene.cell = cell ? &*cell : nullptr;
  scene.looking = &work.share;
  return scene;
}

/// One search for contact, with what it refers to.
struct Search
{
  Search(const Problem &problem,
         const State &state,
         const Workspace &work,
         const std::vector<WallMotion<2>> &motion,
         const double dt,
         const std::vector<Eigen::VectorXd> *increment,
         const double share)
      : cell(state.cell_motion(motion))
      , where(contact_scene(problem, state, work, motion, dt, increment, share, cell))
      , by_rank(!work.share.alone() && problem.geometry->looks_by_body())
      , geometry(*problem.geometry)
      , bodies(work.share)
  {
  }
  Search(const Search &) = delete;

  /// All ranks come here, before any of them looks.
  void begin()
  {
    if (!by_rank)
      return;
    moved = share_outlines(bodies, where);
    where.moved = &moved;
  }
  /// Of this rank's bodies where every rank looks for its own, else of all.
  void find() { geometry.find(where, rows); }

  const std::optional<CellMotion> cell;
  ContactScene<2> where;
  const bool by_rank; ///< whether every rank looks for its own bodies
  std::vector<ContactRow<2>> rows;
  const ContactGeometry<2> &geometry;
  const BodyShare &bodies;
  MovedOutlines moved;
};

void take_start_gaps(const GapsByRow &gaps, std::vector<ContactRow<2>> &rows)
{
  for (ContactRow<2> &row : rows)
  {
    const auto gap = gaps.find(row.key);
    if (gap != gaps.end())
      row.gap = gap->second;
  }
}

GapsByRow gaps_where_found(const std::vector<ContactRow<2>> &rows)
{
  GapsByRow gaps;
  gaps.reserve(rows.size());
  for (const ContactRow<2> &row : rows)
    gaps[row.key] = row.gap_where_found;
  return gaps;
}
} // namespace

void find_rows(const Problem &problem,
               const State &state,
               Workspace &work,
               const std::vector<WallMotion<2>> &motion,
               const double dt,
               const std::vector<Eigen::VectorXd> *increment,
               const double share,
               const bool again,
               const GapsByRow *start_gaps)
{
  dealii::TimerOutput::Scope section(*work.timer, "contact search");
  Search search(problem, state, work, motion, dt, increment, share);
  if (again)
    search.where.foresight = 0.5; // the next search sees what this one leaves out
  const auto find = [&]()
  {
    search.find();
    if (start_gaps != nullptr)
      take_start_gaps(*start_gaps, search.rows);
  };
  search.begin();
  if (search.by_rank)
    share_rows(work.share, state.bodies, find,
               {!problem.settings.condenses(), search.where.subgrid.on, problem.pairs.adhere(),
                search.where.obstacles != nullptr, search.where.cell != nullptr},
               search.rows);
  else
    find();
  if (problem.pairs.adhere())
    for (ContactRow<2> &row : search.rows)
      row.pull = row.adhesion * row.length *
                 (row.adhesion > 0. ? state.adhesion.share(row.key, row.gap, row.lift) : 0.);
  work.contact.reinit(std::move(search.rows), work.share, !problem.settings.condenses(), state.bodies, dt,
                      again ? nullptr : &state.memory);
}

FoundGaps true_gaps(const Problem &problem,
                    const State &state,
                    const Workspace &work,
                    const std::vector<WallMotion<2>> &motion,
                    const double dt,
                    const std::vector<Eigen::VectorXd> &increment,
                    const double share)
{
  dealii::TimerOutput::Scope section(*work.timer, "contact search");
  Search search(problem, state, work, motion, dt, &increment, share);
  search.where.gaps_only = true;
  search.begin();
  const Ranks &ranks = work.share.ranks;
  std::vector<double> overlap(ranks.number(), 0.); // the deepest of every rank
  FoundGaps found;
  const auto find = [&]()
  {
    search.find();
    found.here = gaps_where_found(search.rows);
    for (const ContactRow<2> &row : search.rows)
      overlap[ranks.here()] = std::max(overlap[ranks.here()], -row.gap_where_found);
  };
  if (search.by_rank)
    ranks.together(find,
                   [&]()
                   {
                     std::vector<Ranks::Piece> pieces;
                     for (unsigned int r = 0; r < overlap.size(); ++r)
                       pieces.push_back({r, &overlap[r], 1});
                     return pieces;
                   });
  else
    find();
  found.deepest = *std::max_element(overlap.begin(), overlap.end());
  return found;
}

GapsByRow true_gaps_of_all(const Problem &problem,
                           const State &state,
                           const Workspace &work,
                           const std::vector<WallMotion<2>> &motion,
                           const double dt,
                           const std::vector<Eigen::VectorXd> &increment,
                           const double share)
{
  dealii::TimerOutput::Scope section(*work.timer, "contact search");
  Search search(problem, state, work, motion, dt, &increment, share);
  search.where.gaps_only = true;
  search.begin();
  const auto find = [&]() { search.find(); };
  if (search.by_rank)
    return share_gaps_where_found(work.share, state.bodies.size(), find, search.rows);
  find();
  return gaps_where_found(search.rows);
}

Verdict judge(const Problem &problem,
              const State &state,
              const Workspace &work,
              const std::vector<WallMotion<2>> &motion,
              const double dt,
              const std::vector<Eigen::VectorXd> &increment,
              const double share)
{
  dealii::TimerOutput::Scope section(*work.timer, "overlap check");
  Search search(problem, state, work, motion, dt, &increment, share);
  search.where.foresight = 1.; // boxes that meet anywhere on their ways
  search.where.places_only = true;
  if (work.share.alone())
    return judge_outlines(search.where, move_outlines(search.where));
  const MovedOutlines moved = share_outlines(work.share, search.where);
  const Ranks &ranks = work.share.ranks;
  std::vector<Verdict::Numbers> of_ranks(ranks.number(), Verdict().numbers());
  ranks.together([&]() { of_ranks[ranks.here()] = judge_outlines(search.where, moved).numbers(); },
                 [&]()
                 {
                   std::vector<Ranks::Piece> pieces;
                   for (unsigned int r = 0; r < of_ranks.size(); ++r)
                     pieces.push_back({r, of_ranks[r].data(), of_ranks[r].size()});
                   return pieces;
                 });
  Verdict verdict;
  for (const Verdict::Numbers &numbers : of_ranks)
    verdict.take(Verdict::of(numbers));
  return verdict;
}

std::vector<double> end_gaps(const State &state,
                             const Workspace &work,
                             const std::vector<Eigen::VectorXd> &increment,
                             const std::vector<WallMotion<2>> &motion,
                             const double dt)
{
  const auto &rows = work.contact.contact_rows();
  const unsigned int components = work.contact.n_components();
  std::vector<Eigen::VectorXd> rate(increment.size());
  for (unsigned int b = 0; b < increment.size(); ++b)
    if (work.share.mine(b))
      rate[b] = increment[b] / dt;
  const std::vector<double> w = work.contact.relative_velocity(work.share, state.bodies, work.drive, rate);
  std::vector<double> gap(rows.size());
  const std::optional<CellMotion> cell = state.cell_motion(motion);
  for (unsigned int r = 0; r < rows.size(); ++r)
  {
    gap[r] = rows[r].gap + dt * w[r * components];
    if (cell)
      gap[r] += dt * (cell->gradient * rows[r].branch) * rows[r].resultant(0);
    if (rows[r].obstacle)
      gap[r] -= dt * rows[r].partner_velocity * rows[r].normal;
    else if (rows[r].partner == ContactRow<2>::none)
      gap[r] -= dt * motion[rows[r].wall].velocity;
  }
  return gap;
}
} // namespace softgrain::mpm
