// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_analysis_measure_h
#define softgrain_analysis_measure_h

#include <softgrain/analysis/assembly.h>
#include <softgrain/base/registry.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace softgrain
{
/// A number, or nothing where it is not defined: no packing fraction without a box.
using MeasuredValue = std::optional<double>;

/**
 * @brief One or several numbers that describe a state, the same for every model.
 *
 * A new measure is one source in `source/analysis/measures` that registers itself, and a row in
 * doc/measures.md.
 */
class Measure
{
public:
  virtual ~Measure() = default;

  /// Names of the numbers, with the SI unit at their end.
  virtual std::vector<std::string> columns() const = 0;

  /// The numbers, one for every column.
  virtual std::vector<MeasuredValue> evaluate(const Assembly &assembly) const = 0;
};

/// @return true, so that it can initialise a namespace-scope constant.
template <typename Member>
bool register_measure(const std::string &name, const std::string &description)
{
  return Registry<Measure>::instance().add(name, description, [] { return std::make_unique<Member>(); });
}

/// The measures that a user asks for.
class MeasureSet
{
public:
  /// @param names of the registry; `all` stands for every one.
  /// @throw InputError when one is not known.
  explicit MeasureSet(const std::vector<std::string> &names);

  bool empty() const { return measures.empty(); }
  std::vector<std::string> columns() const;

  /// Columns and values in the order of columns(). A body without area or a contact without bodies is a
  /// ComputationError.
  std::vector<std::pair<std::string, MeasuredValue>>
  evaluate(const Snapshot<2> &snapshot, const MeasureContext &context = MeasureContext()) const;

private:
  std::vector<std::unique_ptr<Measure>> measures;
};

/// The measures of a run, snapshot after snapshot: it knows the first one and the one before.
class MeasureSeries
{
public:
  MeasureSeries(const std::vector<std::string> &names, std::optional<double> friction)
      : set(names), friction(friction)
  {
  }

  const MeasureSet &measures() const { return set; }

  /// Values as MeasureSet::evaluate() has them; @p snapshot is the one before for the next call.
  std::vector<std::pair<std::string, MeasuredValue>> evaluate(const Snapshot<2> &snapshot);

  /// Takes a snapshot of the run for the first, or the one before, without measuring it.
  void remember(const Snapshot<2> &snapshot);

private:
  const MeasureSet set;
  const std::optional<double> friction;
  std::optional<Snapshot<2>> first, previous; ///< without points and outlines
};
} // namespace softgrain

#endif
