// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_bpm_timed_section_h
#define softgrain_bpm_timed_section_h

#include <deal.II/base/timer.h>

#include <optional>
#include <string>

namespace softgrain::bpm
{
/// A section of the timer, or nothing when there is no timer.
class TimedSection
{
public:
  TimedSection(dealii::TimerOutput *timer, const std::string &name)
  {
    if (timer != nullptr)
      scope.emplace(*timer, name);
  }

private:
  std::optional<dealii::TimerOutput::Scope> scope;
};
} // namespace softgrain::bpm

#endif
