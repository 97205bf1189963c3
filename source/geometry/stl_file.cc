// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/stl_file.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace softgrain
{
namespace
{
constexpr std::size_t header_of_binary = 84, size_of_triangle = 50;
constexpr double same = 1e-6;     ///< distance of corners that are one, over the extent of all
constexpr double no_area = 1e-12; ///< over the square of the longest side

using Corners = std::array<dealii::Point<3>, 3>;

[[noreturn]] void refuse(const std::string &path, const std::string &why)
{
  throw InputError(path + " is not an STL file: " + why);
}

std::vector<Corners> read_binary(const std::string &bytes)
{
  std::vector<Corners> triangles((bytes.size() - header_of_binary) / size_of_triangle);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    // A normal comes first, which the corners tell as well.
    float numbers[12];
    std::memcpy(numbers, bytes.data() + header_of_binary + t * size_of_triangle, sizeof numbers);
    for (unsigned int k = 0; k < 3; ++k)
      for (unsigned int d = 0; d < 3; ++d)
        triangles[t][k][d] = numbers[3 + 3 * k + d];
  }
  return triangles;
}

std::vector<Corners> read_ascii(const std::string &path, const std::string &text)
{
  std::istringstream words(text);
  std::string word;
  std::vector<dealii::Point<3>> corners;
  bool ended = false;
  while (words >> word)
    if (word == "vertex")
    {
      dealii::Point<3> corner;
      if (!(words >> corner[0] >> corner[1] >> corner[2]))
        refuse(path,
               "three numbers must follow the word 'vertex' number " + std::to_string(corners.size() + 1));
      corners.push_back(corner);
    }
    else
      ended = ended || word == "endsolid";
  if (corners.size() % 3 != 0 || !ended)
    refuse(path, "it ends within a triangle");
  std::vector<Corners> triangles(corners.size() / 3);
  for (std::size_t i = 0; i < corners.size(); ++i)
    triangles[i / 3][i % 3] = corners[i];
  return triangles;
}

/// Numbers corners; those at nearly the same place have one number. Programs that write a file round the
/// corners of each triangle for itself.
class Joiner
{
public:
  /// @param within distance of corners that are one [m]
  Joiner(const double within, std::vector<dealii::Point<3>> &vertices) : within(within), vertices(vertices) {}

  unsigned int number_of(const dealii::Point<3> &x)
  {
    const Box box = box_of(x);
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
        for (long k = -1; k <= 1; ++k)
          if (const auto known = boxes.find({{box[0] + i, box[1] + j, box[2] + k}});
              known != boxes.end() && vertices[known->second].distance(x) <= within)
            return known->second;
    const unsigned int number = vertices.size();
    vertices.push_back(x);
    boxes.insert({box, number});
    return number;
  }

private:
  using Box = std::array<long, 3>;

  Box box_of(const dealii::Point<3> &x) const
  {
    Box box{};
    for (unsigned int d = 0; d < 3 && within > 0.; ++d)
      box[d] = std::lround(x[d] / within);
    return box;
  }

  const double within;
  std::vector<dealii::Point<3>> &vertices;
  std::map<Box, unsigned int> boxes;
};

bool is_binary(const std::string &bytes)
{
  if (bytes.size() < header_of_binary)
    return false;
  std::uint32_t n;
  std::memcpy(&n, bytes.data() + header_of_binary - sizeof n, sizeof n);
  return bytes.size() == header_of_binary + size_of_triangle * static_cast<std::size_t>(n);
}

bool has_area(const Corners &c)
{
  const dealii::Tensor<1, 3> ab = c[1] - c[0], ac = c[2] - c[0], bc = c[2] - c[1];
  return dealii::cross_product_3d(ab, ac).norm() >
         no_area * std::max({ab.norm_square(), ac.norm_square(), bc.norm_square()});
}
} // namespace

TriangulatedSurface read_stl(const std::string &path, const double scale)
{
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file.is_open() || file.bad())
    throw InputError("cannot read " + path);
  const bool binary = is_binary(bytes);
  if (!binary && bytes.compare(0, 5, "solid") != 0)
    refuse(path, "it begins neither with the word 'solid' nor with a header and a number of triangles that "
                 "fits its size");
  std::vector<Corners> list = binary ? read_binary(bytes) : read_ascii(path, bytes);
  double extent = 0.;
  for (Corners &corners : list)
    for (dealii::Point<3> &corner : corners)
    {
      corner *= scale;
      if (!std::isfinite(corner.norm_square()))
        refuse(path, "a corner of a triangle is not finite");
      extent = std::max(extent, corner.distance(list[0][0]));
    }
  TriangulatedSurface surface;
  Joiner joiner(same * extent, surface.vertices);
  for (const Corners &corners : list)
  {
    if (!has_area(corners))
      continue;
    const std::array<unsigned int, 3> triangle = {
        {joiner.number_of(corners[0]), joiner.number_of(corners[1]), joiner.number_of(corners[2])}};
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
      surface.triangles.push_back(triangle);
  }
  if (surface.triangles.empty())
    refuse(path, "it has no triangle with an area");
  return surface;
}
} // namespace softgrain
