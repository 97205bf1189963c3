// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/output/series.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <system_error>

namespace softgrain
{
std::string series_number(const std::size_t number)
{
  const std::string digits = std::to_string(number);
  return std::string(digits.size() < 6 ? 6 - digits.size() : 0, '0') + digits;
}

std::string exact_text(const double number)
{
  char buffer[32];
  return std::string(buffer, std::to_chars(buffer, buffer + sizeof(buffer), number).ptr);
}

void remove_series_files(const std::string &folder,
                         const std::vector<std::string> &prefixes,
                         const std::string &suffix,
                         const std::set<std::string> &kept)
{
  const auto ends_with = [](const std::string &text, const std::string &end)
  { return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0; };
  const auto belongs = [&](std::string name)
  {
    if (ends_with(name, ".part"))
      name.resize(name.size() - 5);
    if (!ends_with(name, suffix))
      return false;
    name.resize(name.size() - suffix.size());
    return std::any_of(prefixes.begin(), prefixes.end(),
                       [&](const std::string &prefix)
                       {
                         return name.compare(0, prefix.size(), prefix) == 0 &&
                                name.size() >= prefix.size() + 6 &&
                                name.find_first_not_of("0123456789", prefix.size()) == std::string::npos;
                       });
  };
  std::error_code error; // what cannot be removed does no harm
  std::vector<std::filesystem::path> stale;
  for (const auto &entry : std::filesystem::directory_iterator(folder, error))
    if (belongs(entry.path().filename()) && kept.count(entry.path().filename()) == 0)
      stale.push_back(entry.path());
  for (const std::filesystem::path &path : stale)
    std::filesystem::remove(path, error);
}

void remove_series(const std::string &index,
                   const std::string &folder,
                   const std::vector<std::string> &prefixes,
                   const std::string &suffix)
{
  std::error_code error;
  std::filesystem::remove(index, error);
  std::filesystem::remove(index + ".part", error);
  remove_series_files(folder, prefixes, suffix, {});
  std::filesystem::remove(folder, error); // refuses when something else is in it
}

std::vector<dealii::Point<2>> wall_segment(const Snapshot<2> &snapshot, const unsigned int wall)
{
  const dealii::Point<2> origin = snapshot.walls[wall].point;
  const dealii::Tensor<1, 2> normal = snapshot.walls[wall].normal;
  dealii::Tensor<1, 2> along;
  along[0] = normal[1];
  along[1] = -normal[0];

  // How far the bodies reach along the wall, and a margin.
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double begin = infinity, end = -infinity;
  const auto reach = [&](const dealii::Point<2> &point)
  {
    begin = std::min(begin, (point - origin) * along);
    end = std::max(end, (point - origin) * along);
  };
  for (const BodyState<2> &body : snapshot.bodies)
  {
    reach(body.center);
    for (const auto &ring : body.outline)
      std::for_each(ring.begin(), ring.end(), reach);
  }
  if (begin > end)
    return {};
  // The wall is drawn up to the walls that it meets. Where these are far from the bodies, it ends a little
  // outside of the bodies.
  const double extent = end - begin;
  double first = begin - 0.1 * extent, last = end + 0.1 * extent;
  for (unsigned int other = 0; other < snapshot.walls.size(); ++other)
  {
    const double slope = snapshot.walls[other].normal * along;
    if (other == wall || std::abs(slope) < 1e-10)
      continue;
    const double meeting = (snapshot.walls[other].point - origin) * snapshot.walls[other].normal / slope;
    if (slope > 0 && meeting > begin - 0.5 * extent)
      first = meeting;
    else if (slope < 0 && meeting < end + 0.5 * extent)
      last = meeting;
  }
  begin = first;
  end = last;
  if (!(begin < end))
    return {};
  return {origin + begin * along, origin + end * along};
}
} // namespace softgrain
