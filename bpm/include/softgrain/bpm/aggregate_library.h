// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_aggregate_library_h
#define softgrain_bpm_aggregate_library_h

#include <softgrain/bpm/aggregate.h>

#include <map>
#include <string>

namespace softgrain::bpm
{
/**
 * @brief Prepared aggregates in a CSV file, `key,x_m,y_m,radius_m`, one row per primary.
 *
 * The key is made from all that an aggregate depends on, so that a changed parameter finds no old aggregate.
 */
class AggregateLibrary
{
public:
  /// Reads @p file if it exists; an empty name keeps nothing. @throw InputError when it is not such a file.
  explicit AggregateLibrary(const std::string &file);

  /// The aggregate kept under @p key, or null.
  const Aggregate<2> *find(const std::string &key) const;

  void add(const std::string &key, const Aggregate<2> &aggregate);

  /// Writes the file, whole or not at all, if something was added. @throw InputError when it cannot be
  /// written.
  void save() const;

private:
  std::string file;
  std::map<std::string, Aggregate<2>> aggregates;
  bool changed = false;
};

/// Key of the aggregate that make_aggregate() would make: 16 hexadecimal digits.
std::string aggregate_key(const BodyDescription<2> &body,
                          double density,
                          const std::string &law,
                          const Settings &settings,
                          std::uint64_t seed);
} // namespace softgrain::bpm

#endif
