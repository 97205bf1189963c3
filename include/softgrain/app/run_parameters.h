// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_run_parameters_h
#define softgrain_app_run_parameters_h

#include <softgrain/analysis/contact_loads.h>
#include <softgrain/output/field_writer.h>
#include <softgrain/output/snapshot_file.h>

#include <string>
#include <vector>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
/// How a run is carried out and what it leaves behind: the top of the file and section `Output`.
struct RunParameters
{
  std::string model;
  std::string output_directory;
  std::vector<std::string> libraries;
  unsigned int threads = 0;       ///< 0: one per core
  double fields_every = 0;        ///< [s]; 0: no pictures
  double snapshots_every = 0;     ///< [s]; 0: no snapshots
  unsigned int history_every = 1; ///< steps
  double checkpoint_minutes = 10; ///< of wall time; 0: only at the end
  unsigned int checkpoints_kept = 2;
  FieldOptions fields;
  SnapshotOptions snapshots;
  std::vector<LoadWish> loads;       ///< columns of the history
  std::vector<std::string> measures; ///< names of the registry, or all; taken with every snapshot

  /// @param models what `Model` may say
  static void declare_parameters(dealii::ParameterHandler &prm,
                                 const std::vector<std::string> &models,
                                 unsigned int dimension = 2);

  /// @param file_name of the parameter file: names the output folder when nothing else does.
  /// @param end_time of the scene, over which a number of outputs is spread; 0: none
  /// @throw InputError when the number of outputs has no end time to be spread over, or measures have no
  /// times.
  void parse_parameters(dealii::ParameterHandler &prm, const std::string &file_name, double end_time);
};
} // namespace softgrain

#endif
