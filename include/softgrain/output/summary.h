// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_summary_h
#define softgrain_output_summary_h

#include <cstdint>
#include <map>
#include <string>

namespace softgrain
{
/// What bodies are made of.
struct PointCount
{
  std::string name; ///< "material_points" or "primaries"
  std::uint64_t number = 0;
};

/// How wrong a run has been at most.
struct RunErrors
{
  double contact_residual = 0;
  double penetration = 0; ///< [m]
  double momentum = 0;
  double energy_balance = 0;
};

/// What `summary.json` says of a run, for scripts that compare many.
struct Summary
{
  std::string status; ///< "running", "completed", "interrupted" or "failed"
  std::string model;
  std::uint64_t steps = 0;
  double simulated_time = 0;    ///< [s]
  double wall_seconds = 0;      ///< of all parts of a run that was restarted
  double processor_seconds = 0; ///< of all threads of the first process, in all parts of a run
  unsigned int threads = 1;     ///< of each process
  unsigned int ranks = 1;
  std::uint64_t bodies = 0;
  PointCount points;
  RunErrors errors;
  std::uint64_t peak_memory = 0;        ///< [bytes]
  std::map<std::string, double> phases; ///< seconds
  std::string version;

  /// Wall time over points and steps [µs]; 0 before the first step.
  double microseconds_per_point_step() const;
};

/// Writes `summary.json` into the folder, whole; a number that is not finite becomes null.
void write_summary(const std::string &directory, const Summary &summary);

/**
 * @brief Writes over the `summary.json` that is there, in its place: on a full disk there is room for nothing
 * else.
 *
 * Fails silently, for it is called when another error is already on its way to the user.
 */
void overwrite_summary(const std::string &directory, const Summary &summary);

/// Largest memory this process has held so far [bytes].
std::uint64_t peak_memory();
} // namespace softgrain

#endif
