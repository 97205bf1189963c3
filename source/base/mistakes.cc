// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/mistakes.h>

#include <algorithm>

namespace softgrain
{
namespace
{
/// More lines than this would push the first off the screen.
constexpr std::size_t most = 10;

std::string joined(const std::vector<std::string> &lines)
{
  std::string text;
  for (const std::string &line : lines)
    text += (text.empty() ? "" : "\n") + line;
  return text;
}

/// What belongs together: "Bodies/left" for all parameters of a body, "Contact" for those of a section
/// without sections of its own.
std::string part_of(const std::string &path)
{
  const std::size_t first = path.find('/');
  const std::size_t second = first == std::string::npos ? first : path.find('/', first + 1);
  return path.substr(0, second == std::string::npos ? first : second);
}
} // namespace

InputErrors::InputErrors(const std::vector<std::string> &lines) : InputError(joined(lines)), each(lines) {}

void Mistakes::add(const std::string &message, const std::string &path)
{
  doubt(path);
  std::string line = message;
  std::replace(line.begin(), line.end(), '\n', ' ');
  if (std::find(messages.begin(), messages.end(), line) == messages.end())
    messages.push_back(line);
}

void Mistakes::doubt(const std::string &path)
{
  if (!path.empty())
    parts.push_back(part_of(path));
}

void Mistakes::add(const InputError &error)
{
  if (const auto *const several = dynamic_cast<const InputErrors *>(&error))
    for (const std::string &line : several->lines())
      add(line);
  else
    add(std::string(error.what()));
}

bool Mistakes::concern(const std::string &message) const
{
  for (std::size_t open = message.find('\''); open != std::string::npos; open = message.find('\'', open + 1))
  {
    const std::size_t close = message.find('\'', open + 1);
    if (close == std::string::npos)
      break;
    const std::string part = part_of(message.substr(open + 1, close - open - 1));
    for (const std::string &wrong : parts)
      if (part == wrong || part.compare(0, wrong.size() + 1, wrong + "/") == 0)
        return true;
  }
  return false;
}

void Mistakes::end() const
{
  if (messages.empty())
    return;
  std::vector<std::string> lines(messages.begin(), messages.begin() + std::min(most, messages.size()));
  if (messages.size() > most)
    lines.push_back("and " + std::to_string(messages.size() - most) + " more");
  throw InputErrors(lines);
}
} // namespace softgrain
