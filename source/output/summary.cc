// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/output/atomic_file.h>
#include <softgrain/output/summary.h>

#include <nlohmann/json.hpp>

#include <sys/resource.h>

#include <filesystem>
#include <fstream>

namespace softgrain
{
double Summary::microseconds_per_point_step() const
{
  return steps == 0 || points.number == 0 ? 0.
                                          : wall_seconds * 1e6 / (static_cast<double>(points.number) * steps);
}

namespace
{
std::string summary_path(const std::string &directory)
{
  return (std::filesystem::path(directory) / "summary.json").string();
}

std::string text_of(const Summary &summary)
{
  nlohmann::ordered_json json;
  json["status"] = summary.status;
  json["model"] = summary.model;
  json["steps"] = summary.steps;
  json["simulated_time_s"] = summary.simulated_time;
  json["wall_seconds"] = summary.wall_seconds;
  json["processor_seconds"] = summary.processor_seconds;
  json["threads"] = summary.threads;
  json["ranks"] = summary.ranks;
  json["bodies"] = summary.bodies;
  json[summary.points.name] = summary.points.number;
  json["microseconds_per_point_step"] = summary.microseconds_per_point_step();
  json["max_contact_residual"] = summary.errors.contact_residual;
  json["max_penetration_m"] = summary.errors.penetration;
  json["momentum_error"] = summary.errors.momentum;
  json["energy_balance_error"] = summary.errors.energy_balance;
  json["peak_memory_bytes"] = summary.peak_memory;
  json["phases"] = summary.phases;
  json["version"] = summary.version;
  return json.dump(2) + "\n";
}
} // namespace

void write_summary(const std::string &directory, const Summary &summary)
{
  write_file_atomically(summary_path(directory), text_of(summary));
}

void overwrite_summary(const std::string &directory, const Summary &summary)
{
  std::string text = text_of(summary);
  std::fstream file(summary_path(directory), std::ios::in | std::ios::out | std::ios::binary);
  // Blanks over what is left of a longer text.
  file.seekg(0, std::ios::end);
  const std::streamoff old_size = file.tellg();
  if (old_size > static_cast<std::streamoff>(text.size()))
    text.resize(old_size, ' ');
  file.seekp(0);
  file << text << std::flush;
}

std::uint64_t peak_memory()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024; // Linux counts in kilobytes
}
} // namespace softgrain
