// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_parameters_parameter_listing_h
#define softgrain_parameters_parameter_listing_h

#include <softgrain/parameters/parameter_tree.h>

#include <iosfwd>

namespace softgrain
{
/// Prints a parameter file, which can be read back; with meaning and range as comments, or with values alone.
void print_prm(std::ostream &out, const ParameterSection &top, bool with_documentation);

/// Prints nested JSON objects; a parameter is an object with value, default, allowed, meaning.
void print_json(std::ostream &out, const ParameterSection &top);

/// Prints Markdown, one table per section.
void print_markdown(std::ostream &out, const ParameterSection &top);
} // namespace softgrain

#endif
