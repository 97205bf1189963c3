// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_rank_report_h
#define softgrain_mpm_model_rank_report_h

#include <softgrain/model/model.h>
#include <softgrain/mpm/body/body_share.h>

#include <algorithm>
#include <string>
#include <vector>

/// @file
/// What reports say of several ranks, and whether these agree.

namespace softgrain::mpm
{
/// How many bodies that move each rank has; also reported.
template <int dim>
std::vector<unsigned int>
report_bodies_of_ranks(const BodyShare &share, const std::vector<Body<dim>> &bodies, SizeReport &report)
{
  std::vector<unsigned int> number(share.exchange.number(), 0);
  for (const Body<dim> &body : bodies)
    if (!body.rigid.driven)
      ++number[share.owner(body.index)];
  const auto [fewest, most] = std::minmax_element(number.begin(), number.end());
  report.emplace_back("bodies of a rank", std::to_string(*fewest) + " to " + std::to_string(*most));
  return number;
}

/// Warns of ranks that have nothing to do. @param number of the bodies of each rank
inline void report_idle_ranks(const std::vector<unsigned int> &number, SizeReport &report)
{
  if (const auto idle = std::count(number.begin(), number.end(), 0u); idle > 0)
    report.emplace_back("warning", std::to_string(idle) + " of " + std::to_string(number.size()) +
                                       " ranks have no body and nothing to do");
}

/// Makes sure that all ranks have made the same step. @throw ComputationError for all when they have not
template <int dim>
void check_ranks_agree(const BodyShare &share, const std::vector<Body<dim>> &bodies, const StepReport &report)
{
  if (share.alone())
    return;
  double moved = 0.;
  for (const Body<dim> &body : bodies)
    moved += body.nodes.displacement.squaredNorm();
  share.exchange.check_alike({report.dt, report.newton_residual, report.contact_residual, moved});
}
} // namespace softgrain::mpm

#endif
