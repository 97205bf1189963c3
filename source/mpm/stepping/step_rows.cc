// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/row_velocity.h>
#include <softgrain/mpm/contact/share_outlines.h>
#include <softgrain/mpm/stepping/step_rows.h>

#include <deal.II/base/timer.h>

#include <utility>

namespace softgrain::mpm
{
void find_rows(const Problem &problem,
               const State &state,
               Workspace &work,
               const std::vector<WallMotion<2>> &motion,
               const double dt)
{
  dealii::TimerOutput::Scope section(*work.timer, "contact search");
  std::vector<ContactRow<2>> rows;
  problem.geometry->find({state.bodies, motion, problem.pairs, dt, problem.lattice->cell_size()}, rows);
  if (problem.pairs.adhere())
    for (ContactRow<2> &row : rows)
      row.law.pull = row.law.adhesion * row.length *
                     (row.law.adhesion > 0. ? state.adhesion.share(row.key, row.gap) : 0.);
  work.contact.reinit(std::move(rows), work.share, !problem.settings.condenses(), state.bodies, dt,
                      state.memory);
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
  const std::optional<CellMotion<2>> cell = state.cell_motion(motion);
  const OutlineScene scene{state.bodies,
                           work.drive,
                           motion,
                           dt,
                           problem.lattice->cell_size(),
                           increment,
                           share,
                           state.obstacles.empty() ? nullptr : &state.obstacles,
                           cell ? &*cell : nullptr,
                           &work.share};
  if (work.share.alone())
    return judge_outlines(scene, move_outlines(scene));
  const MovedOutlines moved = share_outlines(work.share, scene);
  const std::vector<Verdict::Numbers> verdicts =
      work.share.exchange.told_by_all(Verdict().numbers(), [&](Verdict::Numbers &numbers)
                                      { numbers = judge_outlines(scene, moved).numbers(); });
  Verdict verdict;
  for (const Verdict::Numbers &numbers : verdicts)
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
  const std::vector<double> w = relative_velocity(state, work, rate);
  std::vector<double> gap(rows.size());
  for (unsigned int r = 0; r < rows.size(); ++r)
  {
    gap[r] = rows[r].gap + dt * w[r * components];
    gap[r] -= way_of_partner(rows[r], motion, 0, dt);
  }
  return gap;
}
} // namespace softgrain::mpm
