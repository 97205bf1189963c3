// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_stop_condition_h
#define softgrain_driving_stop_condition_h

#include <softgrain/base/registry.h>
#include <softgrain/model/model.h>
#include <softgrain/scene/scene.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
class StateReader;
class StateWriter;

/// What a stop condition looks at.
template <int dim>
struct RunStateIn
{
  const Model<dim> &model;
  const std::vector<WallState<dim>> &walls_at_start;
  const Loads<dim> &loads;                     ///< on all bodies
  double time_slack = 0;                       ///< what counts as having arrived [s]
  double begin = 0;                            ///< from when times count [s]
  const std::vector<double> *memory = nullptr; ///< what note() has kept; of this condition alone
  bool ends_anyway = false;                    ///< whether the run ends at some time, whatever happens
};
using RunState = RunStateIn<2>;

/**
 * @brief One reason to end a run: a parameter of section `Stop`, and how far the run is from it.
 */
class StopCondition
{
public:
  virtual ~StopCondition() = default;

  /// Name of the parameter in section `Stop`; a value above 0 asks for the condition.
  virtual std::string key() const = 0;

  /// Declares key(), and more if there is more; the handler stands in section `Stop`.
  virtual void declare_parameters(dealii::ParameterHandler &prm) const = 0;

  /// Reads what is declared beside key(); the handler stands in section `Stop`. @throw InputError
  virtual void parse_parameters(const dealii::ParameterHandler &) {}

  /// How the condition is to be understood in `softgrain check`, "axial strain 0.3". @p limit of key()
  virtual std::string in_words(double limit) const = 0;

  /// The time at which the run ends at the latest [s]; 0: nobody knows.
  virtual double end_time(const double) const { return 0.; }

  /// Whether it can be measured in @p scene, whose packing may still be missing. @throw InputError
  virtual void check(const Scene<2> &, const double) const {}

  /// Whether it makes sense for @p scene with all its bodies. @throw InputError
  virtual void check_start(const Scene<2> &, const double) const {}

  /// Called once after every step, by conditions that look back: what @p memory keeps goes into checkpoints.
  virtual void note(const RunState &, const double, std::vector<double> & /*memory*/) const {}

  /// Whether what the bodies do decides, and nobody can tell beforehand when.
  virtual bool depends_on_bodies() const { return false; }

  /// Part of the way to @p limit that the run has made; 1 or more: it ends.
  virtual double fraction_done(const RunState &state, double limit) const = 0;

  /// Whether it can be measured where 'Dimension' is 3.
  virtual bool works_in_space() const { return false; }
  /// check() and check_start() there; a packing may still be missing. @throw InputError
  virtual void check_in_space(const Scene<3> &, const double) const {}
  /// The same part there, of conditions that work there.
  virtual double fraction_done_in_space(const RunStateIn<3> &, double) const { return 0.; }
};

template <>
Registry<StopCondition> &Registry<StopCondition>::instance();

/// What conditions that look back have kept, by their keys.
using StopMemory = std::map<std::string, std::vector<double>>;

/// Saves @p memory in a checkpoint, under @p name. A run may go on with other conditions than before.
void save(StateWriter &out, const std::string &name, const StopMemory &memory);
StopMemory load_stop_memory(const StateReader &in, const std::string &name);

/// Section `Stop`: the run ends with the first condition that is met.
class StopConditions
{
public:
  /// Declares section `Stop`; the handler stands at its top.
  static void declare_parameters(dealii::ParameterHandler &prm);
  /// @throw InputError when there is none, unless @p may_be_empty
  void parse_parameters(dealii::ParameterHandler &prm, bool may_be_empty = false);

  bool empty() const { return asked.empty(); }

  void check(const Scene<2> &scene) const;
  /// check() and check_start() where 'Dimension' is 3. @throw InputError for conditions that do not work
  /// there, too
  void check_in_space(const Scene<3> &scene) const;
  void check_start(const Scene<2> &scene) const;

  /// The earliest end that is known beforehand [s]; 0: none.
  double end_time() const;
  /// Whether what the bodies do may end it before.
  bool depend_on_bodies() const;
  /// Lets the conditions see a step that has been made. @param memory of all conditions, empty at the start
  void note(const RunState &now, StopMemory &memory) const;
  double fraction_done(const RunState &state, const StopMemory &memory) const;
  /// Notes nothing in space, where no condition looks back.
  void note(const RunStateIn<3> &, StopMemory &) const {}
  double fraction_done(const RunStateIn<3> &state, const StopMemory &) const;
  /// "t = 1 s, axial strain 0.3".
  std::string in_words() const;

private:
  struct Asked
  {
    std::shared_ptr<const StopCondition> condition;
    double limit;
  };
  std::vector<Asked> asked;
};

/// @throw InputError unless @p scene has walls of these @p names, which 'Stop/KEY' is measured between
template <int dim>
void need_walls(const Scene<dim> &scene, const std::string &key, const std::vector<std::string> &names);

/// "0.3", or "2 s" with a unit.
std::string number_in_words(double value, const std::string &unit = "");
} // namespace softgrain

#endif
