// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_unused_settings_h
#define softgrain_mpm_model_unused_settings_h

#include <softgrain/mpm/model/settings.h>
#include <softgrain/parameters/parameter_tree.h>

#include <string>
#include <vector>

namespace softgrain::mpm
{
/// A line for every parameter that is not at its default and that these settings do not read: the time scheme
/// or the geometry of contact has no use for it. @param all the parameters from which the settings were read
std::vector<std::string> unused_settings(const ParameterSection &all, const Settings &settings);
} // namespace softgrain::mpm

#endif
