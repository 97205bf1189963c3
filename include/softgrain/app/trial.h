// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_trial_h
#define softgrain_app_trial_h

#include <softgrain/app/input.h>
#include <softgrain/model/forecast.h>

#include <optional>
#include <string>
#include <vector>

namespace softgrain
{
/**
 * @brief What some seconds of computing have shown of a run.
 *
 * Formulas know cells, steps and how large things are. They do not know how often steps are cut, nor how many
 * iterations friction, corners or matter that forgets take. The same scene with coarser cells or larger
 * primaries does, and takes a part of the time.
 */
struct Trial
{
  /// How far it was when.
  struct Mark
  {
    double fraction, steps, seconds;
  };

  ParameterValues coarser;  ///< what is coarser in it; empty: nothing
  unsigned int steps = 0;   ///< made
  double seconds = 0.;      ///< of processor time in them
  double preparation = 0.;  ///< of processor time before them, without the packing
  double packing = 0.;      ///< of processor time
  double fraction = 0.;     ///< of the way to the end of the run
  double time = 0.;         ///< simulated [s]
  double all_steps = 0.;    ///< that the whole way is expected to take, and
  double all_seconds = 0.;  ///< their processor time: what is left goes on as the last part of the way
  std::vector<Mark> marks;  ///< before each step
  ParameterValues rest_of;  ///< what was coarser in a trial of which the rest of the way is known
  bool has_corners = false; ///< several bodies, some with corners
  std::string failure;      ///< why it ended, unless at its end or because the time was up

  /// What was tried and how far it went, in words for the report.
  std::string in_words() const;
};

/**
 * @brief Makes the scene of @p input, coarser if that is needed, and goes its way for at most @p seconds on
 * the clock. No file is written.
 *
 * The packing is made first, however long it takes.
 * @param outline, forecast are corrected by what is found; their seconds are then those of this machine
 * @throw InputError as when a model is made, and when nothing can be foretold of the scene
 */
Trial try_out(Input &input,
              std::optional<RunOutline> &outline,
              std::optional<Forecast> &forecast,
              double seconds);

/**
 * @brief @p formula corrected by what @p trial has shown.
 * @param of_trial what the formula says of the trial
 */
Forecast learned_from(const Trial &trial, const Forecast &formula, const Forecast &of_trial);
} // namespace softgrain

#endif
