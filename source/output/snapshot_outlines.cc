// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/output/snapshot_outlines.h>

#include <algorithm>
#include <cstdint>

namespace softgrain
{
using namespace snapshot_rows;

namespace
{
/// Whether @p list begins with 0, ends with @p end and never falls.
bool rising(const std::vector<std::uint64_t> &list, const std::size_t end)
{
  return !list.empty() && list.front() == 0 && list.back() == end && std::is_sorted(list.begin(), list.end());
}

[[noreturn]] void refuse(const Hdf5File &file, const std::string &name)
{
  throw InputError("cannot read '" + name + "' from " + file.name() + ": the offsets do not fit");
}
} // namespace

void write_outlines(const Hdf5Group &file, const std::vector<BodyState<2>> &bodies)
{
  std::vector<std::uint64_t> ring_offsets{0}, point_offsets{0};
  std::vector<double> rows;
  for (const BodyState<2> &body : bodies)
  {
    for (const std::vector<dealii::Point<2>> &ring : body.outline)
    {
      for (const dealii::Point<2> &point : ring)
        put(rows, point);
      point_offsets.push_back(rows.size() / 2);
    }
    ring_offsets.push_back(point_offsets.size() - 1);
  }
  file.write("outlines/body_offsets", ring_offsets);
  file.write("outlines/ring_offsets", point_offsets);
  file.write("outlines/points_m", rows, 2);
}

void read_outlines(const Hdf5File &file, const std::string &group, std::vector<BodyState<2>> &bodies)
{
  const std::vector<std::uint64_t> rings = file.read_integers(group + "outlines/body_offsets");
  const std::vector<std::uint64_t> offsets = file.read_integers(group + "outlines/ring_offsets");
  std::vector<dealii::Point<2>> points;
  read_rows(file, group + "outlines/points_m", points);
  if (rings.size() != bodies.size() + 1 || !rising(offsets, points.size()) ||
      !rising(rings, offsets.size() - 1))
    refuse(file, group + "outlines");
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (std::size_t r = rings[b]; r < rings[b + 1]; ++r)
      bodies[b].outline.emplace_back(points.begin() + static_cast<std::ptrdiff_t>(offsets[r]),
                                     points.begin() + static_cast<std::ptrdiff_t>(offsets[r + 1]));
}

void write_lines(const Hdf5Group &file, const std::vector<ObstacleState<2>> &obstacles)
{
  std::vector<std::uint64_t> offsets{0};
  std::vector<double> rows;
  for (const ObstacleState<2> &obstacle : obstacles)
  {
    for (const dealii::Point<2> &point : obstacle.line)
      put(rows, point);
    offsets.push_back(rows.size() / 2);
  }
  file.write("obstacles/line_offsets", offsets);
  file.write("obstacles/points_m", rows, 2);
}

void read_lines(const Hdf5File &file, const std::string &group, std::vector<ObstacleState<2>> &obstacles)
{
  const std::vector<std::uint64_t> offsets = file.read_integers(group + "obstacles/line_offsets");
  std::vector<dealii::Point<2>> points;
  read_rows(file, group + "obstacles/points_m", points);
  if (offsets.size() != obstacles.size() + 1 || !rising(offsets, points.size()))
    refuse(file, group + "obstacles");
  for (std::size_t o = 0; o < obstacles.size(); ++o)
    obstacles[o].line.assign(points.begin() + static_cast<std::ptrdiff_t>(offsets[o]),
                             points.begin() + static_cast<std::ptrdiff_t>(offsets[o + 1]));
}

void write_outlines(const Hdf5Group &file, const std::vector<BodyState<3>> &bodies)
{
  std::vector<std::uint64_t> vertex_offsets{0}, triangle_offsets{0}, triangles;
  std::vector<double> rows;
  for (const BodyState<3> &body : bodies)
  {
    for (const dealii::Point<3> &vertex : body.outline.at(0))
      put(rows, vertex);
    for (const std::array<unsigned int, 3> &triangle : body.triangles)
      triangles.insert(triangles.end(), triangle.begin(), triangle.end());
    vertex_offsets.push_back(rows.size() / 3);
    triangle_offsets.push_back(triangles.size() / 3);
  }
  file.write("surfaces/vertex_offsets", vertex_offsets);
  file.write("surfaces/triangle_offsets", triangle_offsets);
  file.write("surfaces/vertices_m", rows, 3);
  file.write("surfaces/triangles", triangles, 3);
}

void read_outlines(const Hdf5File &file, const std::string &group, std::vector<BodyState<3>> &bodies)
{
  const std::vector<std::uint64_t> first = file.read_integers(group + "surfaces/vertex_offsets"),
                                   begin = file.read_integers(group + "surfaces/triangle_offsets"),
                                   corners = file.read_integers(group + "surfaces/triangles");
  std::vector<dealii::Point<3>> vertices;
  read_rows(file, group + "surfaces/vertices_m", vertices);
  if (first.size() != bodies.size() + 1 || begin.size() != bodies.size() + 1 ||
      !rising(first, vertices.size()) || !rising(begin, corners.size() / 3) || corners.size() % 3 != 0)
    refuse(file, group + "surfaces");
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    bodies[b].outline.emplace_back(vertices.begin() + static_cast<std::ptrdiff_t>(first[b]),
                                   vertices.begin() + static_cast<std::ptrdiff_t>(first[b + 1]));
    for (std::size_t t = begin[b]; t < begin[b + 1]; ++t)
    {
      std::array<unsigned int, 3> triangle;
      for (unsigned int k = 0; k < 3; ++k)
      {
        if (corners[3 * t + k] >= bodies[b].outline[0].size())
          refuse(file, group + "surfaces");
        triangle[k] = static_cast<unsigned int>(corners[3 * t + k]);
      }
      bodies[b].triangles.push_back(triangle);
    }
  }
}
} // namespace softgrain
