// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_waiting_output_h
#define softgrain_app_waiting_output_h

#include <softgrain/analysis/snapshot.h>
#include <softgrain/output/history.h>

#include <optional>

namespace softgrain
{
class CheckpointReader;
class CheckpointWriter;
class StateReader;
class StateWriter;

/// Which files of a run get something from one state.
struct OutputParts
{
  bool history = false, fields = false, snapshots = false, measures = false;
  bool stage = false; ///< the checkpoint that is kept of the end of a stage

  bool any() const { return history || fields || snapshots || measures || stage; }
};

/**
 * @brief What is to be written of a state, and is not yet on the disk.
 *
 * A state counts as saved when all that is due at it is on the disk. When the disk refuses some of it, the
 * rest goes into the checkpoint of that state as it was to be written: not all of it can be made again from
 * the state, for that has no memory of the step that led to it. The run that goes on writes it first.
 */
template <int dim>
struct WaitingOutput
{
  OutputParts parts;   ///< what waits, known to all
  OutputParts written; ///< what of the present state is on the disk and stays there
  HistoryLine history; ///< only the first process has this and the following
  HistoryLine measures;
  std::optional<Snapshot<dim>> snapshot; ///< of pictures and snapshots

  void save(CheckpointWriter &writer) const;
  /// @param content whether lines and snapshot are read too
  static WaitingOutput load(const CheckpointReader &reader, bool content);
};
} // namespace softgrain

#endif
