// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_usage_h
#define softgrain_app_usage_h

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace softgrain
{
/// Adds examples, and what the values of options are, to the help of the program and of its commands.
void add_examples(CLI::App &app);

/**
 * @brief Says what is wrong with a command line that could not be parsed.
 *
 * A word that is not a command, or an option that the command does not have, is answered with the nearest
 * name.
 * @param app the program with all of its commands
 * @param words what was typed, without the name of the program
 * @param otherwise the message when neither is the case
 */
std::string
explain_mistake(const CLI::App &app, const std::vector<std::string> &words, const std::string &otherwise);
} // namespace softgrain

#endif
