// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_run_statistics_h
#define softgrain_app_run_statistics_h

#include <softgrain/model/model.h>
#include <softgrain/output/summary.h>

#include <chrono>

namespace softgrain
{
class StateReader;
class StateWriter;

/**
 * @brief What is watched over a whole run, parts before a restart included: extremes, energy balance, times.
 */
class RunStatistics
{
public:
  /// Takes the energies of the start from @p model.
  explicit RunStatistics(const AnyModel &model);

  void add_step(const StepReport &report);
  /// Adds the energies of a recorded step, and what @p rounding alone can make of energies then [J/m].
  /// @throw ComputationError when one is no number
  void add_energies(const Energies &energies, double rounding);

  /// Whether anything had kinetic energy when energies were added.
  bool has_moved() const { return moved; }

  /// Counts @p seconds as spent on output.
  void add_output_seconds(double seconds) { output_seconds += seconds; }

  /// |stored + dissipated - work done - stored at the start| over the largest of these terms so far. No
  /// number (NaN) while all of them are what rounding makes.
  double energy_balance_error() const;

  double wall_seconds() const;
  /// Processor time of all threads of this process and of the parts before a restart, preparation included
  /// [s].
  double processor_time() const;

  Summary summary(const std::string &status, const AnyModel &model) const;

  void save(StateWriter &writer) const;
  void load(const StateReader &reader);

private:
  const std::chrono::steady_clock::time_point begin;
  double earlier_wall_seconds = 0;
  double earlier_processor_seconds = 0;
  double output_seconds = 0;
  double max_contact_residual = 0;
  double max_penetration = 0;
  double energy_at_start;
  double largest_energy;
  bool moved = false;
  double rounding = 0;     ///< of energies [J/m]
  double energy_error = 0; ///< now [J/m]
};
} // namespace softgrain

#endif
