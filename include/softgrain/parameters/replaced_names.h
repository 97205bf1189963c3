// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_parameters_replaced_names_h
#define softgrain_parameters_replaced_names_h

#include <softgrain/parameters/parameter_file.h>

#include <vector>

namespace softgrain
{
class Mistakes;

/**
 * @brief What @p assignments say once every list "Names" has its last value.
 *
 * A file that includes another, or --set, may replace a list of stages, walls or bodies. What the replaced
 * file says in the sections of names that are not listed any more is left out. What stands in the same file
 * as the last list, or comes after it, stays: there it is a mistake, of which apply() tells.
 *
 * A name that takes the place of another, and of which nothing is set, is added to @p mistakes: nobody has
 * described it, so it is likely misspelt.
 *
 * @param assignments in the order in which they count, the last most
 */
std::vector<ParameterAssignment> without_replaced_names(const std::vector<ParameterAssignment> &assignments,
                                                        Mistakes &mistakes);
} // namespace softgrain

#endif
