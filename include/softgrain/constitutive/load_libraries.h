// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_load_libraries_h
#define softgrain_constitutive_load_libraries_h

#include <string>
#include <vector>

namespace softgrain::constitutive
{
/**
 * @brief Loads shared libraries for the rest of the program; the laws they define register themselves.
 *
 * To be called before declare_all_laws(), so that parameters of the new laws are known. A name that exists as
 * a file is opened as that file (also without "./" in front), any other is left to the dynamic loader's
 * search path. A library that is already loaded is not loaded twice.
 *
 * @param paths the value of the parameter "Additional shared libraries".
 * @throw InputError with the reason when a library cannot be loaded or brings a law whose name is taken.
 */
void load_libraries(const std::vector<std::string> &paths);
} // namespace softgrain::constitutive

#endif
