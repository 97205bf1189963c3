// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_python_script_h
#define softgrain_app_python_script_h

#include <string>
#include <vector>

namespace softgrain
{
/**
 * @brief Becomes `python3 NAME.py ARGUMENTS…`, so that the script's exit code is the program's.
 *
 * Looks beside the installed program (`../share/softgrain/python`) and in the tree it was built from.
 * @throw InputError when script or interpreter are missing; otherwise does not return.
 */
[[noreturn]] void run_python_script(const std::string &name, const std::vector<std::string> &arguments);
} // namespace softgrain

#endif
