// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_plugin_interface_h
#define softgrain_base_plugin_interface_h

#include <string>

/// Raised with every change of a header that a library of parts must be built anew
/// for.
#define SOFTGRAIN_PLUGIN_INTERFACE "5"

namespace softgrain
{
/**
 * @brief Is in every library that registers a part and says for which interface it was built.
 *
 * It is read from the file before the library is loaded: what is loaded runs, and would already fail.
 */
[[gnu::used]] static const char plugin_interface_mark[] =
    "softgrain plug-in interface " SOFTGRAIN_PLUGIN_INTERFACE ".";

/// @throw InputError when the library @p file was built for another interface; @p name is what the user calls
/// it.
void check_plugin_interface(const std::string &file, const std::string &name);
} // namespace softgrain

#endif
