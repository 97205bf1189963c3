// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/model/state_file.h>

namespace softgrain
{
std::string ListSize::in_words() const
{
  return (several ? "rows of " : "") + std::to_string(unit) + (unit == 1 ? " number" : " numbers");
}

void StateReader::check_size(const std::string &name, const std::size_t found, const ListSize size) const
{
  if (!size.allows(found))
    refuse(name, "it has " + std::to_string(found) + " numbers, and this run needs " + size.in_words());
}

void StateReader::read_rows(const std::string &name,
                            const std::size_t n_rows,
                            const std::size_t width,
                            const Take &take) const
{
  check_size(name, size(name), n_rows * width);
  rows(name, width, take);
}

std::vector<double> StateReader::read_doubles(const std::string &name, const ListSize size) const
{
  std::vector<double> values = doubles(name);
  check_size(name, values.size(), size);
  return values;
}

std::vector<std::uint64_t>
StateReader::read_integers(const std::string &name, const ListSize size, const std::uint64_t end) const
{
  std::vector<std::uint64_t> values = integers(name);
  check_size(name, values.size(), size);
  for (const std::uint64_t value : values)
    if (end > 0 && value >= end)
      refuse(name, "it holds " + std::to_string(value) + ", and the largest number allowed is " +
                       std::to_string(end - 1));
  return values;
}

std::vector<std::uint64_t> StateReader::read_keys(const std::string &name, const ListSize size) const
{
  std::vector<std::uint64_t> keys = read_integers(name, size);
  for (std::size_t k = 1; k < keys.size(); ++k)
    if (keys[k] <= keys[k - 1])
      refuse(name, "its keys do not rise");
  return keys;
}
} // namespace softgrain
