// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/stage_path.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/model/state_file.h>

namespace softgrain
{
namespace
{
const char *const state_name = "driver/stage", *const seen_name = "driver/stage_seen";
}

StagePath::StagePath(const Stages &stages, Model<2> &model, const dealii::Tensor<1, 2> &gravity)
    : stages(stages), model(model), gravity(gravity), walls_at_begin(model.walls())
{
}

void StagePath::begin()
{
  if (!stages.empty())
    model.take_drives(stages[0].drives);
}

void StagePath::next()
{
  ++current;
  begin_time = model.time();
  walls_at_begin = model.walls();
  seen.clear();
  model.take_drives(stages[current].drives);
}

RunState StagePath::state(const double slack) const
{
  return {model, walls_at_begin, slack, begin_time, gravity};
}

void StagePath::note(const double slack)
{
  if (!stages.empty())
    stages[current].stop.note(state(slack), seen);
}

double StagePath::fraction_of_stage(const double slack) const
{
  return stages.empty() ? 0. : stages[current].stop.fraction_done(state(slack), seen);
}

double StagePath::fraction_done(const double slack) const
{
  if (stages.empty())
    return 0.;
  const double part = fraction_of_stage(slack);
  if (is_last())
    return part >= 1. ? 1. : (current + part) / stages.size();
  return (current + (part < 1. ? part : 1.)) / stages.size();
}

double StagePath::end_time() const
{
  const double length = stages.empty() ? 0. : stages[current].stop.end_time();
  return length > 0. ? begin_time + length : 0.;
}

void StagePath::save(StateWriter &writer) const
{
  if (stages.empty())
    return;
  std::vector<double> numbers = {static_cast<double>(current), begin_time};
  for (const WallState<2> &wall : walls_at_begin)
    numbers.insert(numbers.end(), {wall.point[0], wall.point[1]});
  writer.write(state_name, numbers);
  softgrain::save(writer, seen_name, seen);
}

void StagePath::load(const StateReader &reader)
{
  if (stages.empty())
    return;
  const std::vector<double> numbers = reader.read_doubles(state_name);
  if (numbers.size() != 2 + 2 * walls_at_begin.size() || numbers[0] >= stages.size())
    throw InputError("the checkpoint was made with other stages");
  current = static_cast<unsigned int>(numbers[0]);
  begin_time = numbers[1];
  seen = load_stop_memory(reader, seen_name);
  for (std::size_t w = 0; w < walls_at_begin.size(); ++w)
    walls_at_begin[w].point = dealii::Point<2>(numbers[2 + 2 * w], numbers[3 + 2 * w]);
  for (unsigned int n = 0; n <= current; ++n)
    model.take_drives(stages[n].drives);
}
} // namespace softgrain
