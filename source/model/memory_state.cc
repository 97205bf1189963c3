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
  doubles[name] = values;
}

void MemoryState::write(const std::string &name, const std::vector<std::uint64_t> &values)
{
  integers[name] = values;
}

void MemoryState::write(const std::string &name, const std::string &text)
{
  texts[name] = text;
}

std::vector<double> MemoryState::read_doubles(const std::string &name) const
{
  return find(doubles, name);
}

std::vector<std::uint64_t> MemoryState::read_integers(const std::string &name) const
{
  return find(integers, name);
}

std::string MemoryState::read_text(const std::string &name) const
{
  return find(texts, name);
}

bool MemoryState::contains(const std::string &name) const
{
  return doubles.count(name) + integers.count(name) + texts.count(name) > 0;
}
} // namespace softgrain
