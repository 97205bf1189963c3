// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_input_estimates_h
#define softgrain_app_input_estimates_h

#include <softgrain/model/forecast.h>
#include <softgrain/model/model_factory.h>

#include <memory>
#include <optional>

namespace softgrain
{
class Input;

/// What can be said of the run of an Input before it is made: how large it is, what it costs, what makes it
/// coarser. Made where it is asked, by Input::estimates().
class InputEstimates
{
public:
  explicit InputEstimates(Input &input) : input(input) {}

  /// Area that the bodies fill at the start, made or expected [m^2].
  double solid_area(const Crowd &bodies) const;

  /// Size and cost of the run; nothing when model or packing cannot say.
  /// @param changes of parameters of the model, for this answer alone
  std::optional<Forecast> forecast(const RunOutline &run, const ParameterValues &changes = {}) const;

  /// What makes the run coarser by @p factor, or as coarse as it may be; nothing when it cannot be.
  ParameterValues coarser(double factor) const;

  /// Makes a model to look at, which writes no file. The scene is completed first.
  /// @param changes of parameters of the model, for this one alone
  /// @throw InputError when the scene does not suit the model
  std::unique_ptr<Model<2>> model(const ParameterValues &changes = {}) const;

private:
  Input &input;
};
} // namespace softgrain

#endif
