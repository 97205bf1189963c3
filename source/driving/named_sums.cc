// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/named_sums.h>
#include <softgrain/model/state_file.h>

#include <sstream>
#include <vector>

namespace softgrain
{
double NamedSums::sum() const
{
  double sum = 0.;
  for (const auto &[name, value] : sums)
    sum += value;
  return sum;
}

void NamedSums::save(StateWriter &out, const std::string &name) const
{
  std::string names;
  std::vector<double> values;
  for (const auto &[of, value] : sums)
  {
    names += of + '\n';
    values.push_back(value);
  }
  out.write(name + "/names", names);
  out.write(name + "/values", values);
}

void NamedSums::load(const StateReader &in, const std::string &name)
{
  sums.clear();
  std::istringstream names(in.read_text(name + "/names"));
  std::vector<std::string> list;
  for (std::string of; std::getline(names, of);)
    list.push_back(of);
  const std::vector<double> values = in.read_doubles(name + "/values", list.size());
  for (std::size_t i = 0; i < list.size(); ++i)
    sums[list[i]] = values[i];
}
} // namespace softgrain
