// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_error_lines_h
#define softgrain_app_error_lines_h

#include <exception>
#include <string>
#include <vector>

namespace softgrain
{
/// Prints every message as one line on stderr, whatever it holds; of several processes that come here the
/// first says them. @return @p exit_code
int report_errors(const std::vector<std::string> &messages, int exit_code);

/// Reports a single message as one line.
int report_error(const std::string &message, int exit_code);

/// deal.II's exceptions carry a banner and a stack; what a user needs is the additional information.
std::string short_message(const std::exception &error);
} // namespace softgrain

#endif
