// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_model_model_factory_h
#define softgrain_model_model_factory_h

#include <softgrain/base/registry.h>
#include <softgrain/model/forecast.h>
#include <softgrain/model/model.h>
#include <softgrain/scene/law_catalogue.h>
#include <softgrain/scene/scene.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
class StateReader;

/// Parameters and their values, "Section/Key" each.
using ParameterValues = std::vector<std::pair<std::string, std::string>>;

/**
 * @brief How a model enters the program: it registers one of these under the name users write in `Model`.
 *
 * @code
 * const bool registered = Registry<ModelFactory>::instance().add("mpm", "Material point method …",
 *   [] { return std::make_unique<MpmModelFactory>(); });
 * @endcode
 */
class ModelFactory
{
public:
  virtual ~ModelFactory() = default;

  /// Declares the model's own sections; the handler stands at its top and is left there. A section may be
  /// shared with the scene (`Contact` is).
  virtual void declare_parameters(dealii::ParameterHandler &prm) const = 0;

  /// Parameters of the model that a run may change when it goes on from a checkpoint: "Section/Key", or
  /// "Section/" with all that is in it. What the state of a run means must not depend on them.
  virtual std::vector<std::string> changeable_on_restart() const = 0;

  /// Whether several processes can work on the model together.
  virtual bool works_on_ranks() const { return false; }
  /// Whether they can in space.
  virtual bool works_on_ranks_in_space() const { return false; }

  /// What `Materials/NAME/Law` may say.
  virtual LawCatalogue laws() const = 0;

  /**
   * @brief Refuses what does not fit together, before anything is computed.
   *
   * @p prm as for create(); the packing of @p scene may not be made yet.
   * @throw InputError
   */
  virtual void check(const Scene<2> & /*scene*/, dealii::ParameterHandler & /*prm*/) const {}

  /// What 'Fidelity' (draft, standard or reference) sets where a file does not, for the bodies given:
  /// "Section/Key" and value of each.
  virtual ParameterValues presets(const std::string & /*fidelity*/, const Crowd & /*crowd*/) const
  {
    return {};
  }

  /// Area that the outlines of the bodies will enclose at the start, judged as forecast() judges [m^2].
  virtual double
  solid_area(const Scene<2> & /*scene*/, dealii::ParameterHandler & /*prm*/, const Crowd &crowd) const
  {
    return crowd.area();
  }

  /**
   * @brief Size and cost of a run, judged within a moment; nothing when the model cannot say.
   *
   * @p prm as for create(); the packing of @p scene may not be made yet.
   */
  virtual std::optional<Forecast>
  forecast(const Scene<2> & /*scene*/, dealii::ParameterHandler & /*prm*/, const RunOutline & /*run*/) const
  {
    return std::nullopt;
  }

  /**
   * @brief What makes a run coarser by @p factor, for a trial that costs less and goes the same way; less
   * than that where bodies would not be bodies any more.
   *
   * @p prm as for create().
   * @return nothing when there is no such run
   */
  virtual ParameterValues
  coarser(dealii::ParameterHandler & /*prm*/, const Crowd & /*crowd*/, double /*factor*/) const
  {
    return {};
  }

  /**
   * @brief The model of @p scene at time zero.
   *
   * @p prm stands at its top, filled; the laws of `Materials/NAME` are the model's to read.
   * @throw InputError when scene and parameters do not fit together.
   */
  virtual std::unique_ptr<Model<2>> create(const Scene<2> &scene, dealii::ParameterHandler &prm) const = 0;

  /// The model of @p scene that is looked at and not run: nothing is written, no file that keeps what was
  /// made.
  virtual std::unique_ptr<Model<2>> create_to_look(const Scene<2> &scene, dealii::ParameterHandler &prm) const
  {
    return create(scene, prm);
  }

  /// @name Scenes in space; a model need not know them.
  ///@{
  virtual void check_in_space(const Scene<3> & /*scene*/, dealii::ParameterHandler &prm) const
  {
    refuse_space(prm);
  }
  virtual std::unique_ptr<Model<3>> create_in_space(const Scene<3> & /*scene*/,
                                                    dealii::ParameterHandler &prm) const
  {
    refuse_space(prm);
  }
  ///@}

  /// The model of @p scene that is going to load @p state, from which it may take what is dear to make anew.
  virtual std::unique_ptr<Model<2>>
  create_again(const Scene<2> &scene, dealii::ParameterHandler &prm, const StateReader & /*state*/) const
  {
    return create(scene, prm);
  }

private:
  /// @throw InputError
  [[noreturn]] static void refuse_space(const dealii::ParameterHandler &prm);
};

template <>
Registry<ModelFactory> &Registry<ModelFactory>::instance();
} // namespace softgrain

#endif
