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

template <int dim>
void add_to_row(const std::vector<ObstacleState<dim>> &obstacles, HistoryRow &row)
{
  const std::string axes = "xyz";
  for (const ObstacleState<dim> &obstacle : obstacles)
  {
    for (unsigned int d = 0; d < dim; ++d)
      row.emplace_back(obstacle.name + "_" + axes[d] + "_m", obstacle.pivot[d]);
    row.emplace_back(obstacle.name + "_angle_rad", obstacle.angle);
    for (unsigned int d = 0; d < dim; ++d)
      row.emplace_back(obstacle.name + "_force_" + axes[d] + (dim == 2 ? "_N_per_m" : "_N"),
                       obstacle.force[d]);
    row.emplace_back(obstacle.name + (dim == 2 ? "_torque_N" : "_torque_N_m"), obstacle.torque);
  }
}

} // namespace

template <int dim>
OutputParts Simulation<dim>::all_parts() const
{
  OutputParts parts;
  parts.history = true;
  parts.fields = field_schedule.active();
  parts.snapshots = snapshot_schedule.active();
  parts.measures = parts.snapshots && !measures.measures().empty();
  return parts;
}

template <int dim>
void Simulation<dim>::write_due_output()
{
  waiting = {}; // of the state before
  const bool stage_ends = next_stage_is_due();
  const bool fields_due = field_schedule.reached(model.time(), planner.slack());
  const bool snapshots_due = snapshot_schedule.reached(model.time(), planner.slack());
  // Where a stage or the run ends is on record, whatever the intervals.
  OutputParts parts = all_parts();
  if (!stage_ends && !finished())
  {
    parts.history = model.step() % parameters.history_every == 0;
    parts.fields = fields_due;
    parts.snapshots = snapshots_due;
    parts.measures = parts.measures && snapshots_due;
  }
  parts.stage = stage_ends;
  if (parts.any())
    prepare_output(parts, parts.history ? note_energies() : Energies());
  write_waiting();
}

template <int dim>
void Simulation<dim>::write_last_state()
{
  // A run that has made no step has found this state in its folder, or written it at its start.
  if (model.step() == step_of_start || last_state_tried)
    return;
  last_state_tried = true;
  const OutputParts all = all_parts(), there = waiting.written;
  OutputParts parts;
  parts.history = !there.history;
  parts.fields = all.fields && !there.fields;
  parts.snapshots = all.snapshots && !there.snapshots;
  parts.measures = all.measures && !there.measures;
  try
  {
    if (parts.any())
    {
      if (step_given_up)
        model.forget_attempt();
      prepare_output(parts, parts.history ? model.energies() : Energies());
    }
    write_waiting();
  }
  catch (...)
  {
    waiting = WaitingOutput<dim>(); // it was not due
    waiting.written = there;
    throw;
  }
}

template <int dim>
Energies Simulation<dim>::note_energies()
{
  const Energies energies = model.energies();
  statistics.add_energies(energies, model.energy_of_rounding());
  return energies;
}

template <int dim>
HistoryRow Simulation<dim>::history_row(const Energies &energies) const
{
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  const std::string per_metre = dim == 2 ? "_per_m" : "";
  const std::vector<WallState<dim>> walls = model.walls();
  HistoryRow row = {
      {"time_s", model.time()}, {"step", static_cast<double>(model.step())}, {"dt_s", last_report.dt}};
  for (const WallState<dim> &wall : walls)
  {
    row.emplace_back(wall.name + "_position_m", wall.position);
    row.emplace_back(wall.name + "_force_N" + per_metre, wall.normal_force);
  }
  add_to_row(model.obstacles(), row);
  if (!path.empty())
    row.emplace_back("stage", path.number() + 1.);
  row.emplace_back("axial_strain", axial_strain(walls_at_start, walls).value_or(nothing));
  // Where there is no box to be filled, nobody need know what fills it.
  row.emplace_back("packing_fraction",
                   box_of(walls) ? packing_fraction(walls, model.solid_area()).value_or(nothing) : nothing);
  row.emplace_back("coordination", step_given_up ? nothing : model.coordination());
  row.emplace_back("kinetic_energy_J" + per_metre, energies.kinetic);
  row.emplace_back("elastic_energy_J" + per_metre, energies.elastic);
  row.emplace_back("dissipated_energy_J" + per_metre, energies.dissipated);
  row.emplace_back("external_work_J" + per_metre, energies.external_work);
  const HistoryRow works = model.works();
  row.insert(row.end(), works.begin(), works.end());
  row.emplace_back("contact_residual", last_report.contact_residual);
  row.emplace_back("max_penetration_m", last_report.max_penetration);
  row.emplace_back("newton_iterations", last_report.newton_iterations);
  row.emplace_back("contact_sweeps", last_report.contact_sweeps);
  if constexpr (dim == 2)
    if (!loads.empty())
    {
      const Snapshot<2> touching = model.touching_state();
      const bool known = !step_given_up && ranks.first();
      const HistoryRow felt = known ? loads.evaluate(touching) : loads.unknown();
      row.insert(row.end(), felt.begin(), felt.end());
    }
  const HistoryRow extra = model.extra_history();
  row.insert(row.end(), extra.begin(), extra.end());
  return row;
}

template <int dim>
void Simulation<dim>::prepare_output(const OutputParts &parts, const Energies &energies)
{
  const auto begin = std::chrono::steady_clock::now();
  waiting.parts = parts;
  if (parts.history)
    waiting.history = line_of(history_row(energies));
  if (parts.fields || parts.snapshots)
    waiting.snapshot = model.snapshot();
  if (parts.measures)
    ranks.at_first([this]() { waiting.measures = line_of(measure_row(measures, *waiting.snapshot)); });
  statistics.add_output_seconds(seconds_since(begin));
}

template <int dim>
void Simulation<dim>::write_waiting()
{
  OutputParts &parts = waiting.parts, &written = waiting.written;
  if (!(parts.history || parts.fields || parts.snapshots || parts.measures))
    return;
  const auto begin = std::chrono::steady_clock::now();
  // A part is noted as soon as it is on the disk; the others follow the first rank when all are.
  const auto done = [](bool &waits, bool &is_there)
  {
    is_there = is_there || waits;
    waits = false;
  };
  ranks.at_first(
      [&]()
      {
        lock.check_folder();
        if (parts.history)
          history.write_line(waiting.history);
        done(parts.history, written.history);
        if (parts.fields)
          fields.write(*waiting.snapshot);
        done(parts.fields, written.fields);
        if (parts.snapshots)
          snapshots.append(*waiting.snapshot);
        done(parts.snapshots, written.snapshots);
        if (parts.measures)
          measure_table.write_line(waiting.measures);
        done(parts.measures, written.measures);
      });
  done(parts.history, written.history);
  done(parts.fields, written.fields);
  done(parts.snapshots, written.snapshots);
  done(parts.measures, written.measures);
  waiting.snapshot.reset();
  statistics.add_output_seconds(seconds_since(begin));
}

template <int dim>
void Simulation<dim>::write_state(const std::string &file)
{
  std::unique_ptr<CheckpointWriter> writer;
  ranks.at_first([&]() { writer = std::make_unique<CheckpointWriter>(file); });
  FirstRankWriter of_all(writer.get());
  model.save(of_all);
  const bool stage_ends = stage_is_done(path, planner.slack());
  ranks.at_first(
      [&]()
      {
        of_all.check();
        statistics.save(*writer);
        path.save(*writer, stage_ends);
        save(*writer, stop_seen_name, seen);
        writer->write("driver/natural_step", std::vector<double>{planner.natural_step()});
        save_description(*writer, effective_parameters, scene);
        waiting.save(*writer);
        // What the checkpoint says is written must not be lost where the checkpoint is kept.
        history.bring_to_disk();
        measure_table.bring_to_disk();
        fields.bring_to_disk();
        snapshots.bring_to_disk();
        writer->commit();
      });
}

template <int dim>
void Simulation<dim>::write_checkpoint()
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

template <int dim>
void Simulation<dim>::write_summary(const std::string &status)
{
  ranks.at_first(
      [&]() { softgrain::write_summary(parameters.output_directory, statistics.summary(status, model)); });
}

template class Simulation<2>;
template class Simulation<3>;
} // namespace softgrain
