// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_law_registry_h
#define softgrain_constitutive_law_registry_h

#include <softgrain/base/registry.h>
#include <softgrain/constitutive/law.h>

#include <memory>
#include <string>
#include <vector>

namespace softgrain
{
// The tables live in the library, so that plugins and programs share them.
template <>
Registry<constitutive::Law<2>> &Registry<constitutive::Law<2>>::instance();
template <>
Registry<constitutive::Law<3>> &Registry<constitutive::Law<3>>::instance();
} // namespace softgrain

namespace softgrain::constitutive
{
/**
 * @brief Makes a law known under @p name in every dimension of the template list.
 *
 * Called once, where the law is defined:
 * @code
 * [[maybe_unused]] const bool registered = register_law<NeoHookean>("neo_hookean", "One paragraph.");
 * @endcode
 * This runs before main() or inside dlopen(), where an exception would end the program without a message; so
 * a failure is noted and reported by check_registrations().
 *
 * @return whether the name was free.
 */
template <template <int> class NamedLaw>
bool register_law(const std::string &name, const std::string &description)
{
  return Registry<Law<2>>::instance().add(name, description,
                                          [] { return std::make_unique<NamedLaw<2>>(); }) &&
         Registry<Law<3>>::instance().add(name, description, [] { return std::make_unique<NamedLaw<3>>(); });
}

/// Names that create_law() knows, in alphabetical order.
std::vector<std::string> law_names();

/// Name of the subsection with the parameters of a law that law_names() has.
std::string law_title(const std::string &name);

/**
 * @brief Declares the parameters of every registered law, each in the subsection of its title.
 *
 * The subsections are opened where @p prm stands, for example inside the section of one material.
 */
void declare_all_laws(dealii::ParameterHandler &prm);

/**
 * @brief The law called @p name with its parameters read from the subsection of its title.
 *
 * @throw InputError when the name is unknown (with the nearest known one) or a value is not allowed.
 */
template <int dim>
std::unique_ptr<Law<dim>> create_law(const std::string &name, dealii::ParameterHandler &prm);
} // namespace softgrain::constitutive

#endif
