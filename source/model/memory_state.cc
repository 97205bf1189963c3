// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/model/memory_state.h>

namespace softgrain
{
namespace
{
template <typename T>
const T &find(const std::map<std::string, T> &values, const std::string &name)
{
  const auto found = values.find(name);
  if (found == values.end())
    throw InputError("the state in memory has no '" + name + "' of this type");
  return found->second;
}
} // namespace

void MemoryState::write(const std::string &name, const std::vector<double> &values)
{
  kept_doubles[name] = values;
}

void MemoryState::write(const std::string &name, const std::vector<std::uint64_t> &values)
{
  kept_integers[name] = values;
}

void MemoryState::write(const std::string &name, const std::string &text)
{
  kept_texts[name] = text;
}

void MemoryState::write_rows(const std::string &name,
                             const std::size_t n_rows,
                             const std::size_t width,
                             const Fill &fill)
{
  std::vector<double> &values = kept_doubles[name];
  values.resize(n_rows * width);
  for_pieces(n_rows, width,
             [&](const std::size_t begin, const std::size_t end)
             { fill(begin, end, values.data() + begin * width); });
}

std::size_t MemoryState::size(const std::string &name) const
{
  return find(kept_doubles, name).size();
}

void MemoryState::rows(const std::string &name, const std::size_t width, const Take &take) const
{
  const std::vector<double> &values = find(kept_doubles, name);
  take(0, values.size() / width, values.data());
}

std::vector<double> MemoryState::doubles(const std::string &name) const
{
  return find(kept_doubles, name);
}

std::vector<std::uint64_t> MemoryState::integers(const std::string &name) const
{
  return find(kept_integers, name);
}

std::string MemoryState::text(const std::string &name) const
{
  return find(kept_texts, name);
}

void MemoryState::refuse(const std::string &name, const std::string &why) const
{
  throw InputError("cannot use '" + name + "' of the state in memory: " + why);
}

bool MemoryState::contains(const std::string &name) const
{
  return kept_doubles.count(name) + kept_integers.count(name) + kept_texts.count(name) > 0;
}
} // namespace softgrain
