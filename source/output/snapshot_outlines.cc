// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/output/snapshot_outlines.h>

#include <algorithm>
#include <cstdint>
#include <utility>

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

[[noreturn]] void refuse(const Hdf5Reader &file, const std::string &name)
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

void read_outlines(const Hdf5Reader &file, const std::string &group, std::vector<BodyState<2>> &bodies)
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

void read_lines(const Hdf5Reader &file, const std::string &group, std::vector<ObstacleState<2>> &obstacles)
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

namespace
{
using Vertices = std::vector<dealii::Point<3>>;

const Vertices &vertices_of(const BodyState<3> &body)
{
  return body.outline.at(0);
}

const Vertices &vertices_of(const ObstacleState<3> &obstacle)
{
  return obstacle.line;
}

void set_vertices(Vertices vertices, BodyState<3> &body)
{
  body.outline.push_back(std::move(vertices));
}

void set_vertices(Vertices vertices, ObstacleState<3> &obstacle)
{
  obstacle.line = std::move(vertices);
}

/// Of all items one after the other. @param folder in the file
template <class Item>
void write_triangles(const Hdf5Group &file, const std::string &folder, const std::vector<Item> &items)
{
  std::vector<std::uint64_t> vertex_offsets{0}, triangle_offsets{0}, triangles;
  std::vector<double> rows;
  for (const Item &item : items)
  {
    for (const dealii::Point<3> &vertex : vertices_of(item))
      put(rows, vertex);
    for (const std::array<unsigned int, 3> &triangle : item.triangles)
      triangles.insert(triangles.end(), triangle.begin(), triangle.end());
    vertex_offsets.push_back(rows.size() / 3);
    triangle_offsets.push_back(triangles.size() / 3);
  }
  file.write(folder + "/vertex_offsets", vertex_offsets);
  file.write(folder + "/triangle_offsets", triangle_offsets);
  file.write(folder + "/vertices_m", rows, 3);
  file.write(folder + "/triangles", triangles, 3);
}

template <class Item>
void read_triangles(const Hdf5Reader &file, const std::string &folder, std::vector<Item> &items)
{
  const std::vector<std::uint64_t> first = file.read_integers(folder + "/vertex_offsets"),
                                   begin = file.read_integers(folder + "/triangle_offsets"),
                                   corners = file.read_integers(folder + "/triangles");
  Vertices vertices;
  read_rows(file, folder + "/vertices_m", vertices);
  if (first.size() != items.size() + 1 || begin.size() != items.size() + 1 ||
      !rising(first, vertices.size()) || !rising(begin, corners.size() / 3) || corners.size() % 3 != 0)
    refuse(file, folder);
  for (std::size_t b = 0; b < items.size(); ++b)
  {
    set_vertices({vertices.begin() + static_cast<std::ptrdiff_t>(first[b]),
                  vertices.begin() + static_cast<std::ptrdiff_t>(first[b + 1])},
                 items[b]);
    for (std::size_t t = begin[b]; t < begin[b + 1]; ++t)
    {
      std::array<unsigned int, 3> triangle;
      for (unsigned int k = 0; k < 3; ++k)
      {
        if (corners[3 * t + k] >= vertices_of(items[b]).size())
          refuse(file, folder);
        triangle[k] = static_cast<unsigned int>(corners[3 * t + k]);
      }
      items[b].triangles.push_back(triangle);
    }
  }
}
} // namespace

void write_outlines(const Hdf5Group &file, const std::vector<BodyState<3>> &bodies)
{
  write_triangles(file, "surfaces", bodies);
}

void read_outlines(const Hdf5Reader &file, const std::string &group, std::vector<BodyState<3>> &bodies)
{
  read_triangles(file, group + "surfaces", bodies);
}

void write_lines(const Hdf5Group &file, const std::vector<ObstacleState<3>> &obstacles)
{
  write_triangles(file, "obstacles", obstacles);
}

void read_lines(const Hdf5Reader &file, const std::string &group, std::vector<ObstacleState<3>> &obstacles)
{
  read_triangles(file, group + "obstacles", obstacles);
}
} // namespace softgrain
