// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_restart_check_h
#define softgrain_app_restart_check_h

#include <softgrain/scene/scene.h>

#include <string>
#include <vector>

namespace softgrain
{
class StateReader;
class StateWriter;

/// Keeps in a checkpoint what the run was told: its parameters, and its bodies, which may come from another
/// file.
template <int dim>
void save_description(StateWriter &writer, const std::string &effective_parameters, const Scene<dim> &scene);

/// What may be another in a run that goes on, whatever the model: "Section/Key", "Section/" with all that is
/// in it,
/// "*" for any name. The model adds its own, see ModelFactory::changeable_on_restart().
std::vector<std::string> changeable_in_every_model();

/**
 * @brief Compares a run with the checkpoint it goes on from, parameter by parameter.
 *
 * @param changeable what may be another, as changeable_in_every_model() says it; beside these, all parameters
 * of stages that had not begun
 * @return a line for each parameter that is another and may be: "'Stop/End time': 1 -> 2"
 * @throw InputError that names those that may not be, with the old and the new value
 */
template <int dim>
std::vector<std::string> check_description(const StateReader &reader,
                                           const std::string &effective_parameters,
                                           const Scene<dim> &scene,
                                           std::vector<std::string> changeable);
} // namespace softgrain

#endif
