// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/stage_path.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/model/state_file.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace softgrain
{
namespace
{
const char *const state_name = "driver/stage", *const seen_name = "driver/stage_seen",
                  *const run_done_name = "driver/run_done_at_stage", *const ended_name = "driver/stage_ended";
}

template <int dim>
StagePath<dim>::StagePath(const Stages &stages, Model<dim> &model, const Loads<dim> &loads)
    : stages(stages), model(model), loads(loads), expected(stages.size(), 1.), walls_at_begin(model.walls())
{
}

template <int dim>
void StagePath<dim>::begin()
{
  if (!stages.empty())
    model.take_drives(stages[0].drives);
}

template <int dim>
void StagePath<dim>::expect(const std::vector<double> &durations)
{
  if (durations.empty())
    return;
  AssertDimension(durations.size(), stages.size());
  if (std::accumulate(durations.begin(), durations.end(), 0.) > 0.)
    expected = durations;
}

template <int dim>
void StagePath<dim>::next(const double run_done)
{
  ++current;
  begin_time = model.time();
  run_done_at_begin = run_done;
  walls_at_begin = model.walls();
  seen.clear();
  model.take_drives(stages[current].drives);
}

template <int dim>
RunStateIn<dim> StagePath<dim>::state(const double slack) const
{
  return {model, walls_at_begin, loads, slack, begin_time};
}

template <int dim>
void StagePath<dim>::note(const double slack)
{
  if (!stages.empty())
    stages[current].stop.note(state(slack), seen);
}

template <int dim>
double StagePath<dim>::fraction_of_stage(const double slack) const
{
  return stages.empty() ? 0. : stages[current].stop.fraction_done(state(slack), seen);
}

template <int dim>
double StagePath<dim>::fraction_done(const double slack, const double run_done) const
{
  const double of_run =
      run_done_at_begin < 1. ? (run_done - run_done_at_begin) / (1. - run_done_at_begin) : 1.;
  const double part = std::clamp(std::max(fraction_of_stage(slack), of_run), 0., 1.);
  const auto now = expected.begin() + current;
  return (std::accumulate(expected.begin(), now, 0.) + part * *now) /
         std::accumulate(expected.begin(), expected.end(), 0.);
}

template <int dim>
double StagePath<dim>::end_time() const
{
  const double length = stages.empty() ? 0. : stages[current].stop.end_time();
  return length > 0. ? begin_time + length : 0.;
}

template <int dim>
void StagePath<dim>::save(StateWriter &writer, const bool ends) const
{
  if (stages.empty())
    return;
  std::vector<double> numbers = {static_cast<double>(current), begin_time};
  for (const WallState<dim> &wall : walls_at_begin)
    for (unsigned int d = 0; d < dim; ++d)
      numbers.push_back(wall.point[d]);
  writer.write(state_name, numbers);
  softgrain::save(writer, seen_name, seen);
  writer.write(run_done_name, std::vector<double>{run_done_at_begin});
  writer.write(ended_name, std::vector<std::uint64_t>{ends});
}

std::size_t number_of_stages_begun(const StateReader &reader)
{
  if (!reader.contains(state_name))
    return 0;
  const std::vector<double> numbers = reader.read_doubles(state_name, ListSize::rows_of(2));
  if (numbers.empty() || !(numbers[0] >= 0. && numbers[0] < 1e9))
    reader.refuse(state_name, "there is no number of a stage");
  return static_cast<std::size_t>(numbers[0]) + 1;
}

template <int dim>
bool StagePath<dim>::load(const StateReader &reader)
{
  if (stages.empty())
    return false;
  const std::vector<double> numbers = reader.read_doubles(state_name, 2 + dim * walls_at_begin.size());
  if (!(numbers[0] >= 0. && numbers[0] < stages.size()) || numbers[0] != std::floor(numbers[0]))
    reader.refuse(state_name, "the run has " + std::to_string(stages.size()) + " stages");
  current = static_cast<unsigned int>(numbers[0]);
  begin_time = numbers[1];
  seen = load_stop_memory(reader, seen_name);
  run_done_at_begin = reader.read_doubles(run_done_name, 1)[0];
  const bool ends = reader.read_integers(ended_name, 1, 2)[0] != 0;
  for (std::size_t w = 0; w < walls_at_begin.size(); ++w)
    for (unsigned int d = 0; d < dim; ++d)
      walls_at_begin[w].point[d] = numbers[2 + dim * w + d];
  for (unsigned int n = 0; n <= current; ++n)
    model.take_drives(stages[n].drives);
  return ends;
}

template class StagePath<2>;
template class StagePath<3>;
} // namespace softgrain
