// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/error_lines.h>
#include <softgrain/base/ranks.h>

#include <algorithm>
#include <iostream>

namespace softgrain
{
namespace
{
/// What is longer quotes a file that holds no parameters.
constexpr std::size_t longest_message = 3000, shown_of_end = 300;

/// Where to cut @p text near @p place without parting the bytes of a letter.
std::size_t between_letters(const std::string &text, std::size_t place)
{
  while (place > 0 && (static_cast<unsigned char>(text[place]) & 0xC0) == 0x80)
    --place;
  return place;
}

void print_error(std::string message)
{
  if (message.size() > longest_message)
    message = message.substr(0, between_letters(message, longest_message - shown_of_end)) + " [...] " +
              message.substr(between_letters(message, message.size() - shown_of_end));
  std::replace(message.begin(), message.end(), '\n', ' ');
  // What a file holds may be quoted; a terminal would obey some of it.
  std::replace_if(
      message.begin(), message.end(), [](const unsigned char c) { return c < ' ' || c == 127; }, '?');
  std::cerr << "softgrain: error: " << message << std::endl;
}
} // namespace

int report_errors(const std::vector<std::string> &messages, const int exit_code)
{
  const Ranks ranks;
  ranks.fail_alike(messages.front());
  if (!ranks.first())
    return exit_code;
  std::cout << std::flush;
  for (const std::string &message : messages)
    print_error(message);
  return exit_code;
}

int report_error(const std::string &message, const int exit_code)
{
  return report_errors({message}, exit_code);
}

std::string short_message(const std::exception &error)
{
  const std::string message = error.what(), mark = "Additional information:";
  const auto begin = message.find(mark);
  if (begin == std::string::npos)
    return message;
  const auto end = message.find("\n\n", begin);
  return message.substr(begin + mark.size(), end == std::string::npos ? end : end - begin - mark.size());
}
} // namespace softgrain
