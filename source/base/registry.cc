// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/registry.h>

#include <vector>

namespace softgrain
{
namespace
{
// A function, not a variable: parts register before the variables of this file exist.
std::vector<std::string> &failed_registrations()
{
  static std::vector<std::string> messages;
  return messages;
}
} // namespace

void note_failed_registration(const std::string &message)
{
  failed_registrations().push_back(message);
}

void check_registrations()
{
  std::vector<std::string> messages;
  std::swap(messages, failed_registrations());
  if (!messages.empty())
    throw InputError(join(messages));
}
} // namespace softgrain
