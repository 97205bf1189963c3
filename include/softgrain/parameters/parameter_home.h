// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_parameters_parameter_home_h
#define softgrain_parameters_parameter_home_h

#include <functional>
#include <string>
#include <vector>

namespace softgrain
{
struct ParameterAssignment;
struct ParameterEntry;
struct ParameterSection;

/// What a file says of a parameter of a section, or its default.
using ValueOfEntry =
    std::function<std::string(const std::vector<std::string> &sections, const ParameterEntry &entry)>;

/**
 * @brief Where a parameter belongs that stands in a section that does not have it, for a message: "section
 * 'Materials/gel/Neo-Hookean'".
 *
 * Those sections count that are below the one where it stands, or else below the nearest one above it. Of
 * several the one counts whose name the section above it has chosen: that of Neo-Hookean where 'Law =
 * neo_hookean'. @return empty when no section has it
 */
std::string
home_in_words(const ParameterSection &top, const ParameterAssignment &assignment, const ValueOfEntry &value);
} // namespace softgrain

#endif
