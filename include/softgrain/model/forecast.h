// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_model_forecast_h
#define softgrain_model_forecast_h

#include <softgrain/model/model.h>
#include <softgrain/scene/crowd.h>

#include <string>
#include <vector>

namespace softgrain
{
/// How long a run is and what it writes, as far as that can be known beforehand.
struct RunOutline
{
  Crowd crowd;                ///< the bodies
  bool to_pack = false;       ///< whether some have still to be packed
  double duration = 0.;       ///< simulated [s]; 0: unknown
  std::vector<double> stages; ///< simulated time of each [s]; empty: unknown
  double fastest_wall = 0.;   ///< largest speed of a wall whose motion is given [m/s]
  bool pressed = false;       ///< whether a wall is under pressure
  double n_pictures = 0.;     ///< with fields or snapshots
  double output_every = 0.;   ///< smallest time between pictures; steps end there [s]; 0: none
  double history_every = 1.;  ///< steps

  /// Steps of at most @p dt [s]; 0: unknown.
  double n_steps(double dt) const;
};

/// What processes divide among each other of what a run takes; the rest falls to each of them.
struct DividedParts
{
  double preparation = 0., step = 0., memory = 0.; ///< in [0, 1]
  double pieces = 1.;                              ///< of work: more processes have nothing to do
};

/// What a run will take: judged by numbers, nothing is built.
struct Forecast
{
  SizeReport sizes;                  ///< what a model prints of it
  double n_points = 0.;              ///< material points or primaries
  double step = 0.;                  ///< [s]
  double n_steps = 0.;               ///< 0: unknown
  double preparation = 0.;           ///< processor time before the first step [s]
  double step_seconds = 0.;          ///< processor time of a step, output included [s]
  double memory = 0.;                ///< at its peak [bytes]
  DividedParts divided;              ///< with several processes
  std::vector<std::string> warnings; ///< what the studies say is poor, what cannot be

  /// Whether the model is made within a moment.
  bool is_soon_built() const { return preparation < 0.3 && memory < 3e8; }
  double seconds() const { return preparation + n_steps * step_seconds; } ///< of processor time
  /// What falls to one of @p n processes; its warnings are those of all.
  Forecast of_rank(unsigned int n) const;
};

/// What every process of softgrain takes, with its libraries: [s] and [bytes].
constexpr double start_seconds = 0.3, start_memory = 1.6e8;

/// "about 3400", "2.1 million".
std::string count_in_words(double number);
/// "180 MB", "3.2 GB".
std::string bytes_in_words(double bytes);
} // namespace softgrain

#endif
