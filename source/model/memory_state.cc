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

void MemoryState::write_rows(const std::string &name,
                             const std::size_t n_rows,
                             const std::size_t width,
                             const Fill &fill)
{
  std::vector<double> &values = doubles[name];
  values.resize(n_rows * width);
  for_pieces(n_rows, width,
             [&](const std::size_t begin, const std::size_t end)
             { fill(begin, end, values.data() + begin * width); });
}

std::size_t MemoryState::size(const std::string &name) const
{
  return find(doubles, name).size();
}

void MemoryState::read_rows(const std::string &name, const std::size_t width, const Take &take) const
{
  const std::vector<double> &values = find(doubles, name);
  take(0, values.size() / width, values.data());
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
