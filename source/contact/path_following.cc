// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/contact/active_system.h>
#include <softgrain/contact/contact_path.h>
#include <softgrain/contact/path_following.h>
#include <softgrain/contact/residual.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace softgrain::contact
{
namespace
{
using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Contacts that part faster than this many times the speed of approach take part only when they close.
constexpr double far = 3.;
constexpr unsigned int warm_attempts = 2, few_exchanges = 500; ///< from impulses that are given
/// Exchanges of a path from nothing: where impulses were given a shorter step is cheaper than a long path.
constexpr unsigned int most_after_warm = 3000, most_exchanges = 30000;

/// Contacts that take part: all that carry something or do not part fast, and later those that close too.
class Selection
{
public:
  Selection(const Problem &problem,
            const std::vector<double> &compliance,
            const std::vector<double> &impulses)
      : compliance(compliance), takes_part(problem.n_contacts(), 0)
  {
    const double speed = approach_speed(problem, compliance);
    for (unsigned int i = 0; i < takes_part.size(); ++i)
      takes_part[i] =
          compliance[i] > 0. && (impulses[2 * i] > 0. || problem.free_velocity[2 * i] < far * speed);
  }

  /// Adds those that close with relative velocities @p w. False when there are none.
  bool add_closing(const std::vector<double> &w)
  {
    bool more = false;
    for (unsigned int i = 0; i < takes_part.size(); ++i)
      if (!takes_part[i] && compliance[i] > 0. && w[2 * i] < 0.)
      {
        takes_part[i] = 1;
        more = true;
      }
    return more;
  }

  std::vector<unsigned int> list() const
  {
    std::vector<unsigned int> selected;
    for (unsigned int i = 0; i < takes_part.size(); ++i)
      if (takes_part[i])
        selected.push_back(i);
    return selected;
  }

private:
  const std::vector<double> &compliance;
  std::vector<char> takes_part;
};
} // namespace

double follow_path(const Matrix &W,
                   const Problem &problem,
                   const std::vector<double> &compliance,
                   const SolverSettings &settings,
                   std::vector<double> &impulses,
                   SolverReport &report)
{
  double best = std::numeric_limits<double>::infinity();
  if (approach_speed(problem, compliance) == 0.)
    return best;
  Selection selection(problem, compliance, impulses);
  std::vector<double> from = impulses;
  const bool warm = std::any_of(from.begin(), from.end(), [](const double P) { return P > 0.; });
  for (unsigned int attempt = warm ? 0 : warm_attempts; attempt <= warm_attempts;)
  {
    const bool from_nothing = attempt == warm_attempts;
    if (from_nothing)
      std::fill(from.begin(), from.end(), 0.);
    const std::vector<unsigned int> selected = selection.list();
    ContactPath path(W, problem, compliance, selected, from, from_nothing ? 1. : 1e-2,
                     from_nothing || attempt == 0 ? 0. : 4., attempt);
    const bool arrived = path.follow(!from_nothing ? few_exchanges : warm ? most_after_warm : most_exchanges);
    report.newton_iterations += path.n_exchanges();
    ++attempt;
    if (!arrived)
      continue;
    std::vector<double> P = path.impulses(problem.n_contacts());
    const std::vector<double> w = velocities(W, problem, P);
    const double residual = natural_residual(problem, compliance, P, w);
    if (residual < best)
    {
      best = residual;
      impulses = P;
    }
    if (best <= settings.tolerance)
      break;
    if (selection.add_closing(w)) // on from here, with them
    {
      from = std::move(P);
      attempt = 0;
    }
  }
  return best;
}
} // namespace softgrain::contact
