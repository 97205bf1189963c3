// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/nearest_name.h>
#include <softgrain/driving/stop_condition.h>
#include <softgrain/geometry/box.h>
#include <softgrain/model/state_file.h>
#include <softgrain/parameters/within_section.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <sstream>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::StopCondition)

namespace softgrain
{
namespace
{
const Registry<StopCondition> &known()
{
  return Registry<StopCondition>::instance();
}

/// "'Stop/End time', 'Stop/Axial strain' or …"
std::string all_keys()
{
  std::string text;
  const std::vector<std::string> names = known().names();
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0                  ? "'Stop/"
             : i + 1 == names.size() ? " or 'Stop/"
                                     : ", 'Stop/") +
            known().create(names[i])->key() + "'";
  return text;
}
} // namespace

void StopConditions::declare_parameters(dealii::ParameterHandler &prm)
{
  prm.enter_subsection("Stop");
  for (const std::string &name : known().names())
    known().create(name)->declare_parameters(prm);
  prm.leave_subsection();
}

void StopConditions::parse_parameters(dealii::ParameterHandler &prm, const bool may_be_empty)
{
  const WithinSection section(prm, "Stop");
  for (const std::string &name : known().names())
  {
    std::shared_ptr<StopCondition> condition = known().create(name);
    const double limit = prm.get_double(condition->key());
    condition->parse_parameters(prm);
    if (limit > 0.)
      asked.push_back({condition, limit});
  }
  if (asked.empty() && !may_be_empty)
    throw InputError("the run would never end: set " + all_keys() + " greater than 0");
}

void StopConditions::check(const Scene<2> &scene) const
{
  for (const Asked &one : asked)
    one.condition->check(scene, one.limit);
}

void StopConditions::check_in_space(const Scene<3> &scene) const
{
  for (const Asked &one : asked)
  {
    if (!one.condition->works_in_space())
      throw InputError("'Stop/" + one.condition->key() +
                       "' is not allowed with 'Dimension' = '3', where it is not there yet: leave it at 0");
    one.condition->check_in_space(scene, one.limit);
  }
}

double StopConditions::fraction_done(const RunStateIn<3> &state, const StopMemory &) const
{
  double fraction = 0.;
  for (const Asked &one : asked)
    fraction = std::max(fraction, one.condition->fraction_done_in_space(state, one.limit));
  return fraction;
}

void StopConditions::check_start(const Scene<2> &scene) const
{
  for (const Asked &one : asked)
    one.condition->check_start(scene, one.limit);
}

double StopConditions::end_time() const
{
  double earliest = 0.;
  for (const Asked &one : asked)
  {
    const double end = one.condition->end_time(one.limit);
    if (end > 0. && (earliest == 0. || end < earliest))
      earliest = end;
  }
  return earliest;
}

bool StopConditions::depend_on_bodies() const
{
  return std::any_of(asked.begin(), asked.end(),
                     [](const Asked &one) { return one.condition->depends_on_bodies(); });
}

namespace
{
/// @p state as the condition sees it whose memory is @p own.
RunState with_memory(const RunState &state, const std::vector<double> &own)
{
  return {state.model, state.walls_at_start, state.loads, state.time_slack, state.begin,
          &own,        state.ends_anyway};
}
} // namespace

void StopConditions::note(const RunState &now, StopMemory &memory) const
{
  RunState state = now;
  state.ends_anyway = state.ends_anyway || end_time() > 0.;
  for (const Asked &one : asked)
    one.condition->note(state, one.limit, memory[one.condition->key()]);
}

double StopConditions::fraction_done(const RunState &state, const StopMemory &memory) const
{
  double fraction = 0.;
  const std::vector<double> nothing;
  for (const Asked &one : asked)
  {
    const auto own = memory.find(one.condition->key());
    const RunState seen = with_memory(state, own != memory.end() ? own->second : nothing);
    fraction = std::max(fraction, one.condition->fraction_done(seen, one.limit));
  }
  return fraction;
}

void save(StateWriter &out, const std::string &name, const StopMemory &memory)
{
  std::string keys;
  for (const auto &[key, numbers] : memory)
    if (!numbers.empty())
    {
      out.write(name + "/" + std::to_string(keys.size()), numbers);
      keys += key + '\n';
    }
  out.write(name + "/keys", keys);
}

StopMemory load_stop_memory(const StateReader &in, const std::string &name)
{
  StopMemory memory;
  if (!in.contains(name + "/keys"))
    return memory;
  const std::string keys = in.read_text(name + "/keys");
  for (std::size_t begin = 0; begin < keys.size();)
  {
    const std::size_t end = keys.find('\n', begin);
    if (end == std::string::npos)
      in.refuse(name + "/keys", "its last line has no end");
    memory[keys.substr(begin, end - begin)] =
        in.read_doubles(name + "/" + std::to_string(begin), ListSize::rows_of(1));
    begin = end + 1;
  }
  return memory;
}

std::string StopConditions::in_words() const
{
  std::vector<std::string> words;
  for (const Asked &one : asked)
    words.push_back(one.condition->in_words(one.limit));
  return join(words);
}

template <int dim>
void need_walls(const Scene<dim> &scene, const std::string &key, const std::vector<std::string> &names)
{
  for (const std::string &name : names)
    if (find_wall(scene.walls, name) == nullptr)
      throw InputError("'Stop/" + key + "' cannot be measured: there is no wall named '" + name + "'");
}

template void need_walls<2>(const Scene<2> &, const std::string &, const std::vector<std::string> &);
template void need_walls<3>(const Scene<3> &, const std::string &, const std::vector<std::string> &);

std::string number_in_words(const double value, const std::string &unit)
{
  std::ostringstream text;
  text << value << (unit.empty() ? "" : " ") << unit;
  return text.str();
}
} // namespace softgrain
