// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/stepping/driven_work.h>

#include <algorithm>

namespace softgrain::mpm
{
double give_kinks(const ContactKinks &kinks, const std::vector<DrivenWork> &driven)
{
  double most = 0.;
  for (const DrivenWork &one : driven)
    most += one.most;
  if (most == 0. || kinks.all() == 0.)
    return 0.;
  const double given = std::clamp(kinks.all(), -most, most);
  for (const DrivenWork &one : driven)
    *one.work += given * one.most / most;
  return given / kinks.all();
}
} // namespace softgrain::mpm
