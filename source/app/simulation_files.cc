// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of Simulation that writes: history, pictures, snapshots, checkpoints.
#include <softgrain/analysis/box_measures.h>
#include <softgrain/app/first_rank_writer.h>
#include <softgrain/app/measure_table.h>
#include <softgrain/app/restart_check.h>
#include <softgrain/app/simulation.h>
#include <softgrain/geometry/box.h>
#include <softgrain/output/checkpoint.h>
#include <softgrain/output/summary.h>

#include <limits>
#include <memory>

namespace softgrain
{
namespace
{
double seconds_since(const std::chrono::steady_clock::time_point begin)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}
} // namespace

void Simulation::write_due_output(const StepReport &report)
{
  if (model.step() % parameters.history_every == 0)
    write_history(report);
  const bool fields_due = field_schedule.reached(model.time(), planner.slack());
  const bool snapshots_due = snapshot_schedule.reached(model.time(), planner.slack());
  write_pictures(fields_due, snapshots_due);
}

void Simulation::write_history(const StepReport &report)
{
  const auto begin = std::chrono::steady_clock::now();
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  const std::vector<WallState<2>> walls = model.walls();
  const Energies energies = model.energies();
  statistics.add_energies(energies);
  HistoryRow row = {
      {"time_s", model.time()}, {"step", static_cast<double>(model.step())}, {"dt_s", report.dt}};
  for (const WallState<2> &wall : walls)
  {
    row.emplace_back(wall.name + "_position_m", wall.position);
    row.emplace_back(wall.name + "_force_N_per_m", wall.normal_force);
  }
  for (const ObstacleState<2> &obstacle : model.obstacles())
  {
    row.emplace_back(obstacle.name + "_x_m", obstacle.pivot[0]);
    row.emplace_back(obstacle.name + "_y_m", obstacle.pivot[1]);
    row.emplace_back(obstacle.name + "_angle_rad", obstacle.angle);
    row.emplace_back(obstacle.name + "_force_x_N_per_m", obstacle.force[0]);
    row.emplace_back(obstacle.name + "_force_y_N_per_m", obstacle.force[1]);
    row.emplace_back(obstacle.name + "_torque_N", obstacle.torque);
  }
  if (!path.empty())
    row.emplace_back("stage", path.number() + 1.);
  row.emplace_back("axial_strain", axial_strain(walls_at_start, walls).value_or(nothing));
  // Where there is no box to be filled, nobody need know what fills it.
  row.emplace_back("packing_fraction",
                   box_of(walls) ? packing_fraction(walls, model.solid_area()).value_or(nothing) : nothing);
  row.emplace_back("coordination", model.coordination());
  row.emplace_back("kinetic_energy_J_per_m", energies.kinetic);
  row.emplace_back("elastic_energy_J_per_m", energies.elastic);
  row.emplace_back("dissipated_energy_J_per_m", energies.dissipated);
  row.emplace_back("contact_residual", report.contact_residual);
  row.emplace_back("max_penetration_m", report.max_penetration);
  row.emplace_back("newton_iterations", report.newton_iterations);
  row.emplace_back("contact_sweeps", report.contact_sweeps);
  const HistoryRow extra = model.extra_history();
  row.insert(row.end(), extra.begin(), extra.end());
  ranks.at_first(
      [&]()
      {
        lock.check_folder();
        history.write(row);
      });
  last_history_step = model.step();
  statistics.add_output_seconds(seconds_since(begin));
}

void Simulation::write_pictures(const bool write_fields, const bool write_snapshots)
{
  if (!write_fields && !write_snapshots)
    return;
  const auto begin = std::chrono::steady_clock::now();
  const Snapshot<2> snapshot = model.snapshot();
  ranks.at_first(
      [&]()
      {
        lock.check_folder();
        if (write_fields)
          fields.write(snapshot);
        if (write_snapshots)
          snapshots.append(snapshot);
        if (write_snapshots && !measures.measures().empty())
          measure_table.write(measure_row(measures, snapshot));
      });
  last_picture_step = model.step();
  statistics.add_output_seconds(seconds_since(begin));
}

void Simulation::write_state(const std::string &file)
{
  std::unique_ptr<CheckpointWriter> writer;
  ranks.at_first([&]() { writer = std::make_unique<CheckpointWriter>(file); });
  FirstRankWriter of_all(writer.get());
  model.save(of_all);
  const bool stage_ends = path.stage_is_done(planner.slack());
  ranks.at_first(
      [&]()
      {
        of_all.check();
        statistics.save(*writer);
        path.save(*writer, stage_ends);
        save(*writer, stop_seen_name, seen);
        writer->write("driver/natural_step", std::vector<double>{planner.natural_step()});
        save_description(*writer, effective_parameters, scene);
        writer->commit();
      });
}

void Simulation::write_checkpoint()
{
  const auto begin = std::chrono::steady_clock::now();
  ranks.at_first([this]() { lock.check_folder(); });
  write_state(checkpoint_path(parameters.output_directory, model.step()));
  ranks.at_first(
      [this]()
      {
        // Those of a way that was given up for an older checkpoint would be taken for newer ones.
        remove_checkpoints_after(parameters.output_directory, model.step());
        remove_old_checkpoints(parameters.output_directory, parameters.checkpoints_kept);
      });
  statistics.add_output_seconds(seconds_since(begin));
}

void Simulation::write_summary(const std::string &status)
{
  ranks.at_first(
      [&]() { softgrain::write_summary(parameters.output_directory, statistics.summary(status, model)); });
}
} // namespace softgrain
