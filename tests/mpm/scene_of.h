// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_mpm_scene_of_h
#define softgrain_tests_mpm_scene_of_h

// Tests of the method run the scenes that are shipped, made coarse or short by assignments as on the command
// line.
#include <softgrain/app/input.h>
#include <softgrain/mpm/model/mpm_model.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace softgrain
{
/// The model of a parameter file, changed by assignments; nothing is written, but the folder for it must be
/// possible, and `output` is the file that the test driver keeps.
inline std::unique_ptr<mpm::MpmModel> scene_of_file(const std::string &file, std::vector<std::string> changes)
{
  changes.insert(changes.begin(), "Output directory=results");
  Input input(file, changes);
  return std::unique_ptr<mpm::MpmModel>(dynamic_cast<mpm::MpmModel *>(input.create_model().release()));
}

/// The model of a shipped parameter file, `verification/bar_period.prm` for example, changed by
/// "Section/Key=value".
inline std::unique_ptr<mpm::MpmModel> shipped_scene(const std::string &file,
                                                    const std::vector<std::string> &changes = {})
{
  return scene_of_file(SOFTGRAIN_SOURCE_DIR "/parameters/" + file, changes);
}

/// The model of a parameter file given as text.
inline std::unique_ptr<mpm::MpmModel> scene_of_text(const std::string &text,
                                                    const std::vector<std::string> &changes = {})
{
  std::ofstream("scene.prm") << text;
  return scene_of_file("scene.prm", changes);
}

/// A figure that only has to be small: its limit when it is below, itself when it is not.
inline std::string below(const double limit, const double value)
{
  std::ostringstream text;
  if (std::abs(value) < limit)
    text << "below " << limit;
  else
    text << value;
  return text.str();
}

/// Steps until @p end; @p look is called after every step with the report of the step.
template <typename F>
void run_until(mpm::MpmModel &model, const double end, const F &look)
{
  while (model.time() < end * (1. - 1e-12))
  {
    StepReport report = model.advance(end - model.time());
    model.settle(report); // as in a run that writes every step
    look(report);
  }
}

inline void run_until(mpm::MpmModel &model, const double end)
{
  run_until(model, end, [](const StepReport &) {});
}

/// What energy is missing or too much, over the largest energy seen; the balance of `summary.json`.
class EnergyWatch
{
public:
  explicit EnergyWatch(const mpm::MpmModel &model) : start(total(model.energies())) { look(model); }

  void look(const mpm::MpmModel &model)
  {
    const Energies e = model.energies();
    scale = std::max({scale, e.kinetic + e.elastic, std::abs(e.external_work), e.dissipated});
    worst = std::max(worst, std::abs(total(e) - start));
    most = std::max(most, total(e) - start);
  }
  /// What came from nowhere; losses, as of theta > 1/2, do not count.
  double gained() const { return scale > 0. ? most / scale : 0.; }
  double error() const { return scale > 0. ? worst / scale : 0.; }

private:
  static double total(const Energies &e) { return e.kinetic + e.elastic + e.dissipated - e.external_work; }
  double start, scale = 0., worst = 0., most = 0.;
};
} // namespace softgrain

#endif
