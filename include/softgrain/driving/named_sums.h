// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_named_sums_h
#define softgrain_driving_named_sums_h

#include <map>
#include <string>

namespace softgrain
{
class StateReader;
class StateWriter;

/**
 * @brief Sums since the start, by name: works of loads, losses, and whatever else a column of the history
 * adds up over the steps. Who computes a step adds, checkpoints keep all of them, and only who writes the
 * column need know the name.
 */
class NamedSums
{
public:
  void add(const std::string &name, const double value) { sums[name] += value; }
  void add(const NamedSums &others)
  {
    for (const auto &[name, value] : others.sums)
      add(name, value);
  }
  /// The sum of that name, 0 where nothing was added.
  double of(const std::string &name) const
  {
    const auto found = sums.find(name);
    return found == sums.end() ? 0. : found->second;
  }
  /// All together.
  double sum() const;

  void save(StateWriter &out, const std::string &name) const;
  void load(const StateReader &in, const std::string &name);

private:
  std::map<std::string, double> sums;
};
} // namespace softgrain

#endif
