// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of Simulation that tells the user: head and end of the log.
#include <softgrain/app/simulation.h>
#include <softgrain/base/config.h>
#include <softgrain/base/parallel.h>
#include <softgrain/output/checkpoint.h>

#include <deal.II/base/config.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <tuple>

namespace softgrain
{
std::string head_of_log(const RunParameters &run, const Ranks &ranks)
{
  return std::string("softgrain ") + SOFTGRAIN_VERSION + " (deal.II " + DEAL_II_PACKAGE_VERSION + ", " +
         (ranks.alone() ? "" : std::to_string(ranks.number()) + " ranks, each with ") +
         std::to_string(n_threads()) + " threads)\nmodel " + run.model + ", results in " +
         run.output_directory + '\n';
}

template <int dim>
void Simulation<dim>::open_log(const bool append)
{
  log.open(parameters.output_directory, append);
  // The terminal has had it since before bodies were made.
  log.file() << head_of_log(parameters, ranks);
}

template <int dim>
void Simulation<dim>::print_head()
{
  log.both() << first_lines;
  SizeReport report = model.size_report();
  report.insert(report.end(), expected.begin(), expected.end());
  print_size_report(log.both(), report);
  log.both() << std::flush;
}

template <int dim>
void Simulation<dim>::print_end(const std::string &status)
{
  const Summary summary = statistics.summary(status, model);
  log.both() << status << " at t = " << model.time() << " s after " << model.step() << " steps and "
             << duration_in_words(summary.wall_seconds) << " (" << std::setprecision(3)
             << summary.microseconds_per_point_step() << " us per point and step; "
             << duration_in_words(summary.processor_seconds) << " of processor time)\n";
  // Without inertia nothing is said of momentum.
  for (const auto &[what, error, counts] :
       {std::make_tuple("energy", summary.errors.energy_balance, true),
        std::make_tuple("momentum", summary.errors.momentum, statistics.has_moved())})
    if (counts && !std::isfinite(error))
      log.both() << "there is no balance of " << what << ": no " << what
                 << " was above what rounding makes of it\n";
  constexpr double much = 0.02;
  if (summary.errors.energy_balance > much)
    log.both() << "warning: energy came from nothing, or is gone: the balance misses "
               << 100. * summary.errors.energy_balance
               << " % of the largest energy (energy_balance_error of summary.json); a smaller 'Time/Time "
                  "step' may help"
               << '\n';
  if (status == "interrupted")
    log.both() << "the state is saved in " << checkpoint_path(parameters.output_directory, model.step())
               << "; the same command with --restart goes on from there\n";
  double total = 0;
  for (const auto &phase : summary.phases)
    total += phase.second;
  for (const auto &[name, seconds] : summary.phases)
    log.both() << "  " << std::left << std::setw(30) << name << std::right << std::fixed
               << std::setprecision(2) << std::setw(10) << seconds << " s" << std::setprecision(1)
               << std::setw(7) << (total > 0 ? 100 * seconds / total : 0.) << " %\n";
  log.both() << std::defaultfloat << std::setprecision(6);
  print_ranks();
  log.both() << std::flush;
}

template <int dim>
void Simulation<dim>::print_ranks()
{
  if (ranks.alone())
    return;
  RankTimes here = model.rank_times();
  const RankTimes output = ranks.taken();
  here.own += output.own;
  here.waiting += output.waiting;
  here.messages += output.messages;
  // Of the whole program: what is no rank's own is done alike by all.
  const double alike_here = std::max(0., processor_seconds() - here.own - here.spinning - output.spinning);
  double own = 0., busiest = 0., alike = 0., waiting = 0.; // means, but for the busiest
  for (const std::vector<double> &one : ranks.of_all({here.own, alike_here, here.waiting}))
  {
    own += one[0] / ranks.number();
    busiest = std::max(busiest, one[0]);
    alike += one[1] / ranks.number();
    waiting += one[2] / ranks.number();
  }
  log.both() << std::fixed << std::setprecision(2) << "  processor seconds of a rank: its own work " << own
             << " (the busiest " << busiest << "), what all do alike " << alike << "\n  it waits for others "
             << waiting << " s, in " << here.messages << " exchanges of " << std::setprecision(1)
             << here.bytes / 1e6 << " MB\n"
             << std::defaultfloat << std::setprecision(6);
}

void print_size_report(std::ostream &out, const SizeReport &report)
{
  std::size_t width = 0;
  for (const auto &line : report)
    width = std::max(width, line.first.size());
  for (const auto &[name, value] : report)
    out << "  " << name << std::string(width - name.size() + 2, ' ') << value << '\n';
}

template class Simulation<2>;
template class Simulation<3>;
} // namespace softgrain
