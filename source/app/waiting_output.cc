// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/waiting_output.h>
#include <softgrain/output/checkpoint.h>

#include <cstdint>
#include <string>
#include <vector>

namespace softgrain
{
namespace
{
const std::string written_name = "driver/output/written", waiting_name = "driver/output/waiting",
                  history_name = "driver/output/history", measures_name = "driver/output/measures",
                  snapshot_name = "driver/output/snapshot";

std::vector<std::uint64_t> flags_of(const OutputParts &parts)
{
  return {parts.history, parts.fields, parts.snapshots, parts.measures, parts.stage};
}

OutputParts parts_of(const StateReader &reader, const std::string &name)
{
  const std::vector<std::uint64_t> flags = reader.read_integers(name, flags_of({}).size(), 2);
  return {flags[0] != 0, flags[1] != 0, flags[2] != 0, flags[3] != 0, flags[4] != 0};
}

void save_line(StateWriter &writer, const std::string &name, const HistoryLine &line)
{
  writer.write(name, line.names + '\n' + line.values);
}

HistoryLine line_in(const StateReader &reader, const std::string &name)
{
  const std::string text = reader.read_text(name);
  const std::size_t end = text.find('\n');
  if (end == std::string::npos)
    reader.refuse(name, "it is no row with its names");
  return {text.substr(0, end), text.substr(end + 1)};
}
} // namespace

template <int dim>
void WaitingOutput<dim>::save(CheckpointWriter &writer) const
{
  StateWriter &lists = writer;
  lists.write(written_name, flags_of(written));
  lists.write(waiting_name, flags_of(parts));
  if (parts.history)
    save_line(writer, history_name, history);
  if (parts.measures)
    save_line(writer, measures_name, measures);
  if ((parts.fields || parts.snapshots) && snapshot)
    writer.write_snapshot(snapshot_name, *snapshot);
}

template <int dim>
WaitingOutput<dim> WaitingOutput<dim>::load(const CheckpointReader &reader, const bool content)
{
  WaitingOutput output;
  output.written = parts_of(reader, written_name);
  output.parts = parts_of(reader, waiting_name);
  if (!content)
    return output;
  if (output.parts.history)
    output.history = line_in(reader, history_name);
  if (output.parts.measures)
    output.measures = line_in(reader, measures_name);
  if (output.parts.fields || output.parts.snapshots)
    output.snapshot = reader.read_snapshot<dim>(snapshot_name);
  return output;
}

template struct WaitingOutput<2>;
template struct WaitingOutput<3>;
} // namespace softgrain
