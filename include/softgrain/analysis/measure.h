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
 * doc/measures.md. Measures of the plane and of space are families of their own.
 */
template <int dim>
class MeasureIn
{
public:
  virtual ~MeasureIn() = default;

  /// Names of the numbers, with the SI unit at their end.
  virtual std::vector<std::string> columns() const = 0;

  /// The numbers, one for every column.
  virtual std::vector<MeasuredValue> evaluate(const AssemblyIn<dim> &assembly) const = 0;
};
using Measure = MeasureIn<2>;

/// @return true, so that it can initialise a namespace-scope constant.
template <typename Member, int dim = 2>
bool register_measure(const std::string &name, const std::string &description)
{
  return Registry<MeasureIn<dim>>::instance().add(name, description,
                                                  [] { return std::make_unique<Member>(); });
}

/// The measures that a user asks for.
template <int dim>
class MeasureSetIn
{
public:
  /// @param names of the registry; `all` stands for every one.
  /// @throw InputError when one is not known.
  explicit MeasureSetIn(const std::vector<std::string> &names);

  bool empty() const { return measures.empty(); }
  std::vector<std::string> columns() const;

  /// Columns and values in the order of columns(). A body without area or a contact without bodies is a
  /// ComputationError.
  std::vector<std::pair<std::string, MeasuredValue>>
  evaluate(const Snapshot<dim> &snapshot,
           const MeasureContextIn<dim> &context = MeasureContextIn<dim>()) const;

private:
  std::vector<std::unique_ptr<MeasureIn<dim>>> measures;
};
using MeasureSet = MeasureSetIn<2>;

/// The measures of a run, snapshot after snapshot: it knows the first one and the one before.
template <int dim>
class MeasureSeriesIn
{
public:
  MeasureSeriesIn(const std::vector<std::string> &names, std::optional<double> friction)
      : set(names), friction(friction)
  {
  }

  const MeasureSetIn<dim> &measures() const { return set; }

  /// Values as MeasureSet::evaluate() has them; @p snapshot is the one before for the next call.
  std::vector<std::pair<std::string, MeasuredValue>> evaluate(const Snapshot<dim> &snapshot);

  /// Keeps a snapshot as the first of the run, or as the one before the next, without measuring it.
  void remember(const Snapshot<dim> &snapshot);

private:
  const MeasureSetIn<dim> set;
  const std::optional<double> friction;
  std::optional<Snapshot<dim>> first, previous; ///< without points and outlines
};
using MeasureSeries = MeasureSeriesIn<2>;

template <>
Registry<MeasureIn<2>> &Registry<MeasureIn<2>>::instance();
template <>
Registry<MeasureIn<3>> &Registry<MeasureIn<3>>::instance();
extern template class MeasureSetIn<2>;
extern template class MeasureSetIn<3>;
extern template class MeasureSeriesIn<2>;
extern template class MeasureSeriesIn<3>;
} // namespace softgrain

#endif
