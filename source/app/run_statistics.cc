// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/run_statistics.h>
#include <softgrain/base/config.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>
#include <softgrain/base/ranks.h>
#include <softgrain/model/state_file.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace softgrain
{
namespace
{
const char *const state_name = "driver/statistics", *const processor_name = "driver/processor_seconds";
} // namespace

RunStatistics::RunStatistics(const AnyModel &model) : begin(std::chrono::steady_clock::now())
{
  const Energies energies = model.energies();
  energy_at_start = energies.kinetic + energies.elastic;
  largest_energy = std::max(std::abs(energies.kinetic), std::abs(energies.elastic));
}

void RunStatistics::add_step(const StepReport &report)
{
  max_contact_residual = std::max(max_contact_residual, report.contact_residual);
  max_penetration = std::max(max_penetration, report.max_penetration);
}

void RunStatistics::add_energies(const Energies &energies, const double of_rounding)
{
  rounding = of_rounding;
  moved = moved || energies.kinetic > 0.;
  const std::pair<const char *, double> terms[] = {{"kinetic energy", energies.kinetic},
                                                   {"elastic energy", energies.elastic},
                                                   {"dissipated energy", energies.dissipated},
                                                   {"work of walls and forces", energies.external_work}};
  for (const auto &[name, term] : terms)
  {
    if (!std::isfinite(term))
      throw ComputationError(std::string("the ") + name + " is not finite");
    largest_energy = std::max(largest_energy, std::abs(term));
  }
  energy_error =
      energies.kinetic + energies.elastic + energies.dissipated - energies.external_work - energy_at_start;
}

double RunStatistics::energy_balance_error() const
{
  return largest_energy > rounding ? std::abs(energy_error) / largest_energy
                                   : std::numeric_limits<double>::quiet_NaN();
}

double RunStatistics::wall_seconds() const
{
  return earlier_wall_seconds +
         std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double RunStatistics::processor_time() const
{
  return earlier_processor_seconds + processor_seconds();
}

Summary RunStatistics::summary(const std::string &status, const AnyModel &model) const
{
  Summary summary;
  summary.status = status;
  summary.model = model.name();
  summary.points.name = model.name() == "bpm" ? "primaries" : "material_points";
  summary.steps = model.step();
  summary.simulated_time = model.time();
  summary.wall_seconds = wall_seconds();
  summary.processor_seconds = processor_time();
  summary.threads = n_threads();
  summary.ranks = Ranks().number();
  summary.bodies = model.n_bodies();
  summary.points.number = model.n_points();
  summary.errors.contact_residual = max_contact_residual;
  summary.errors.penetration = max_penetration;
  summary.errors.momentum = model.momentum_error();
  summary.errors.energy_balance = energy_balance_error();
  summary.peak_memory = peak_memory();
  summary.phases = model.phases();
  summary.phases["output"] += output_seconds;
  summary.version = SOFTGRAIN_VERSION;
  return summary;
}

void RunStatistics::save(StateWriter &writer) const
{
  writer.write(state_name, std::vector<double>{wall_seconds(), max_contact_residual, max_penetration,
                                               energy_at_start, largest_energy, energy_error});
  writer.write(processor_name, std::vector<double>{processor_time()});
}

void RunStatistics::load(const StateReader &reader)
{
  const std::vector<double> values = reader.read_doubles(state_name, 6);
  earlier_wall_seconds = values[0];
  max_contact_residual = values[1];
  max_penetration = values[2];
  energy_at_start = values[3];
  largest_energy = values[4];
  energy_error = values[5];
  // Older checkpoints tell the time on the clock alone, which one thread had to itself.
  earlier_processor_seconds =
      reader.contains(processor_name) ? reader.read_doubles(processor_name, 1)[0] : earlier_wall_seconds;
}
} // namespace softgrain
