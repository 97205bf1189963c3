// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/bpm/aggregate_library.h>
#include <softgrain/geometry/shape.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace softgrain::bpm
{
namespace
{
const std::string heading = "key,x_m,y_m,radius_m";
}

AggregateLibrary::AggregateLibrary(const std::string &file_name) : file(file_name)
{
  if (file.empty() || !std::filesystem::exists(file))
    return;
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  const auto complain = [&](const std::size_t number)
  {
    throw InputError("'Primaries/Library': line " + std::to_string(number) + " of '" + file +
                     "' is not one of an aggregate library, which has the columns " + heading);
  };
  if (line != heading && line != heading + '\r')
    complain(1);
  for (std::size_t number = 2; std::getline(in, line); ++number)
  {
    if (!line.empty() && line.back() == '\r') // lines of Windows end with it
      line.pop_back();
    std::istringstream fields(line);
    std::string key;
    std::getline(fields, key, ',');
    std::array<double, 2> place{};
    double radius = 0.;
    char first = 0, second = 0;
    fields >> place[0] >> first >> place[1] >> second >> radius;
    if (key.empty() || !fields || !(fields >> std::ws).eof() || first != ',' || second != ',' ||
        !std::isfinite(place[0] + place[1] + radius) || !(radius > 0.))
      complain(number);
    Aggregate<2> &aggregate = aggregates[key];
    aggregate.position.push_back(place);
    aggregate.radius.push_back(radius);
  }
}

const Aggregate<2> *AggregateLibrary::find(const std::string &key) const
{
  const auto found = aggregates.find(key);
  return found == aggregates.end() ? nullptr : &found->second;
}

void AggregateLibrary::add(const std::string &key, const Aggregate<2> &aggregate)
{
  aggregates[key] = aggregate;
  changed = true;
}

void AggregateLibrary::save() const
{
  if (file.empty() || !changed)
    return;
  const std::string unfinished = file + ".part";
  std::ofstream out(unfinished);
  out << heading << '\n' << std::setprecision(17);
  for (const auto &[key, aggregate] : aggregates)
    for (std::size_t i = 0; i < aggregate.size(); ++i)
      out << key << ',' << aggregate.position[i][0] << ',' << aggregate.position[i][1] << ','
          << aggregate.radius[i] << '\n';
  out.close();
  std::error_code error;
  if (out)
    std::filesystem::rename(unfinished, file, error);
  if (!out || error)
    throw InputError("'Primaries/Library': '" + file + "' cannot be written");
}

std::string aggregate_key(const BodyDescription<2> &body,
                          const double density,
                          const std::string &law,
                          const Settings &settings,
                          const std::uint64_t seed)
{
  std::ostringstream text;
  text << std::setprecision(17) << "aggregate 2;" << law << ';' << density << ';' << seed << ';';
  body.shape->describe(text, body.center);
  const PrimarySettings &p = settings.primaries;
  text << p.sizes.smallest << ';' << p.sizes.largest << ';' << static_cast<int>(p.sizes.form) << ';'
       << p.number;
  // Those of older libraries had none of these.
  if (p.sizes.form >= SizeDistribution::Form::power_law)
    text << ';' << p.sizes.exponent << ';' << p.sizes.mean << ';' << p.sizes.deviation;
  // FNV-1a: short, and the same everywhere.
  std::uint64_t hash = 14695981039346656037ull;
  for (const char c : text.str())
    hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  std::ostringstream key;
  key << std::hex << std::setw(16) << std::setfill('0') << hash;
  return key.str();
}
} // namespace softgrain::bpm
