// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_input_h
#define softgrain_app_input_h

#include <softgrain/app/input_estimates.h>
#include <softgrain/app/run_parameters.h>
#include <softgrain/driving/stages.h>
#include <softgrain/model/model_factory.h>
#include <softgrain/packing/packing.h>
#include <softgrain/parameters/parameter_file.h>
#include <softgrain/scene/scene.h>
#include <softgrain/scene/scene_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace softgrain
{
class Mistakes;
class StateReader;

/**
 * @brief A parameter file together with the words of the command line, read, checked and understood; nothing
 * is computed yet.
 */
class Input
{
public:
  /// What becomes of the code that 'Additional shared libraries' names.
  enum class Libraries
  {
    load,
    leave_out ///< what they would have declared is unknown, see left_out()
  };

  /**
   * @param file_name the parameter file
   * @param assignments "Section/Sub/Key=value", which count more than the file
   * @throw InputErrors with file and line, a line for each mistake
   */
  Input(const std::string &file_name,
        const std::vector<std::string> &assignments,
        Libraries libraries = Libraries::load);

  /// What the file asks for and nobody has loaded.
  struct NotLoaded
  {
    std::vector<std::string> names; ///< of libraries
    /// "FILE:LINE: 'Section/Key' = 'value'" of all that nothing but such a library can know. If there is any,
    /// the scene has not been checked, and nothing can be asked but run().
    std::vector<std::string> unknown;
  };
  const NotLoaded &left_out() const { return not_loaded; }

  const RunParameters &run() const { return run_parameters; }
  /// 2 or 3.
  unsigned int dimension() const { return space ? 3 : 2; }
  /// The scene of the plane, empty in space; complete_scene() adds the bodies of its packing.
  const Scene<2> &scene() const { return described_scene; }
  /// The scene in a dimension that is known to be @p dim.
  template <int dim>
  const Scene<dim> &scene_in() const
  {
    if constexpr (dim == 2)
      return described_scene;
    else
      return *space;
  }
  const StopConditions &stop() const { return stop_conditions; }
  const Stages &stages() const { return described_stages; }

  /// The bodies of the scene, made or expected; nothing when the packing cannot say.
  std::optional<Crowd> crowd() const { return crowd_of(described_scene, is_complete); }

  /// How large the run is, what it costs, what makes it coarser.
  InputEstimates estimates() { return InputEstimates(*this); }

  /// Makes the packing of the scene, once, on all threads. @throw InputError when it cannot be made, or its
  /// bodies do not suit walls and other bodies.
  void complete_scene();

  /// Writes the packing that complete_scene() has made to the file that the user asked for, if any.
  /// @throw InputError when a file of that name has other contents, unless @p overwrite
  void save_packing(bool overwrite) const;

  /// The model of the scene, which is completed first. @throw InputError when the scene does not suit it.
  /// @param state that it is going to load; null: it starts at time zero
  std::unique_ptr<Model<2>> create_model(const StateReader *state = nullptr);
  /// The model of a scene in space, which is completed first.
  std::unique_ptr<Model<3>> create_model_in_space();

  /**
   * @brief Compares with the checkpoint that the run is to go on from.
   * @return a line for each parameter that is another now and may be
   * @throw InputError that names file and parameters when the scene is another
   */
  std::vector<std::string> check_restart(const StateReader &checkpoint, const std::string &file_name) const;

  /// Every parameter with its value, in the form of a parameter file.
  std::string effective_parameters() const;

private:
  friend class InputEstimates;

  Input(const std::string &file_name,
        const std::vector<std::string> &assignments,
        Libraries libraries,
        Mistakes mistakes);

  /// Section by section; what follows from a mistake that is known is no other one.
  void parse_sections(const SceneNames &names, const ModelFactory &factory, Mistakes &mistakes);
  /// What fits together, when each section is right by itself.
  void check_all(const ModelFactory &factory);
  /// @p error with the places of the parameters that it names.
  [[noreturn]] void throw_located(const InputError &error) const;
  /// complete_scene() where 'Dimension' is 3.
  void complete_scene_in_space();
  /// Sets what 'Fidelity' says and the file does not.
  void apply_fidelity(const ModelFactory &factory);
  /// The time at which the run ends if it is known beforehand [s]; 0: it is not.
  double end_time() const;

  ParameterFile file;
  dealii::ParameterHandler prm;
  RunParameters run_parameters;
  Scene<2> described_scene;
  std::optional<Scene<3>> space; ///< where 'Dimension' is 3
  StopConditions stop_conditions;
  Stages described_stages;
  Packing<2> packing; ///< once it is made
  Packing<3> packing_in_space;
  bool is_complete = false;
  NotLoaded not_loaded;
};

/// Declares everything a parameter file of @p model may contain, for bodies, walls and materials of these
/// names.
void declare_all_parameters(dealii::ParameterHandler &prm,
                            const std::string &model,
                            const SceneNames &names,
                            unsigned int dimension = 2);
} // namespace softgrain

#endif
