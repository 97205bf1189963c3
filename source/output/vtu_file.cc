// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>
#include <softgrain/output/vtu_file.h>

#include <zlib.h>

#include <algorithm>
#include <cstring>

namespace softgrain
{
namespace
{
const char *vtk_name(float)
{
  return "Float32";
}
const char *vtk_name(double)
{
  return "Float64";
}
const char *vtk_name(std::int32_t)
{
  return "Int32";
}
const char *vtk_name(std::int64_t)
{
  return "Int64";
}
const char *vtk_name(std::uint8_t)
{
  return "UInt8";
}

/// Nine components are a tensor, row by row; without names ParaView counts them from 0.
std::string component_names(const unsigned int n_components)
{
  std::string names;
  if (n_components == 9)
    for (unsigned int i = 0; i < 9; ++i)
      names += " ComponentName" + std::to_string(i) + "=\"" + "XYZ"[i / 3] + "XYZ"[i % 3] + "\"";
  return names;
}

void append(std::string &bytes, const std::uint64_t number)
{
  bytes.append(reinterpret_cast<const char *>(&number), sizeof(number));
}
} // namespace

VtuFile::VtuFile(const unsigned int compression_level) : compression_level(compression_level) {}

template <int dim>
void VtuFile::add_point(const dealii::Point<dim> &point)
{
  for (unsigned int d = 0; d < 3; ++d)
    coordinates.push_back(d < dim ? point[d] : 0.);
}

template <int dim>
void VtuFile::add_cell(const Cell type, const std::vector<dealii::Point<dim>> &vertices)
{
  for (const dealii::Point<dim> &vertex : vertices)
  {
    connectivity.push_back(static_cast<std::int64_t>(coordinates.size() / 3));
    add_point(vertex);
  }
  offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  types.push_back(static_cast<std::uint8_t>(type));
}

template <int dim>
void VtuFile::add_vertices(const std::vector<dealii::Point<dim>> &points)
{
  for (const dealii::Point<dim> &point : points)
    add_cell<dim>(Cell::vertex, {point});
}

void VtuFile::add_triangles(const std::vector<dealii::Point<3>> &points,
                            const std::vector<std::array<unsigned int, 3>> &triangles)
{
  const std::int64_t first = static_cast<std::int64_t>(coordinates.size() / 3);
  for (const dealii::Point<3> &point : points)
    add_point(point);
  for (const auto &triangle : triangles)
  {
    for (const unsigned int vertex : triangle)
      connectivity.push_back(first + vertex);
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    types.push_back(static_cast<std::uint8_t>(Cell::triangle));
  }
}

template void VtuFile::add_cell<2>(Cell, const std::vector<dealii::Point<2>> &);
template void VtuFile::add_cell<3>(Cell, const std::vector<dealii::Point<3>> &);
template void VtuFile::add_vertices<2>(const std::vector<dealii::Point<2>> &);
template void VtuFile::add_vertices<3>(const std::vector<dealii::Point<3>> &);

template <typename Number>
VtuFile::Array VtuFile::make_array(const std::string &name,
                                   const unsigned int n_components,
                                   const std::vector<Number> &values)
{
  Array array;
  array.name = name;
  array.type = vtk_name(Number());
  array.n_components = n_components;
  array.n_tuples = values.size() / n_components;
  array.bytes.assign(reinterpret_cast<const char *>(values.data()), values.size() * sizeof(Number));
  return array;
}

void VtuFile::add_point_data(const std::string &name,
                             const unsigned int n_components,
                             const std::vector<float> &values)
{
  point_data.push_back(make_array(name, n_components, values));
}

void VtuFile::add_point_data(const std::string &name, const std::vector<std::int32_t> &values)
{
  point_data.push_back(make_array(name, 1, values));
}

void VtuFile::add_cell_data(const std::string &name,
                            const unsigned int n_components,
                            const std::vector<double> &values)
{
  cell_data.push_back(make_array(name, n_components, values));
}

void VtuFile::add_cell_data(const std::string &name, const std::vector<std::int32_t> &values)
{
  cell_data.push_back(make_array(name, 1, values));
}

void VtuFile::add_global(const std::string &name, const double value)
{
  global_data.push_back(make_array(name, 1, std::vector<double>{value}));
}

std::string VtuFile::compressed(const std::string &bytes) const
{
  // VTK's layout: number of blocks, their size, size of a shorter last one (0: none), compressed sizes,
  // blocks.
  constexpr std::size_t block_size = std::size_t(1) << 20;
  const std::size_t n_blocks = (bytes.size() + block_size - 1) / block_size;
  std::string header, blocks;
  append(header, n_blocks);
  append(header, block_size);
  append(header, bytes.size() % block_size);
  std::vector<Bytef> buffer(::compressBound(block_size));
  for (std::size_t block = 0; block < n_blocks; ++block)
  {
    const std::size_t begin = block * block_size;
    uLongf size = buffer.size();
    const int status = ::compress2(
        buffer.data(), &size, reinterpret_cast<const Bytef *>(bytes.data() + begin),
        std::min(block_size, bytes.size() - begin), static_cast<int>(std::min(compression_level, 9u)));
    if (status != Z_OK)
      throw ComputationError("zlib cannot compress the pictures, its status is " + std::to_string(status));
    append(header, size);
    blocks.append(reinterpret_cast<const char *>(buffer.data()), size);
  }
  return header + blocks;
}

std::string VtuFile::text() const
{
  const std::size_t n_points = coordinates.size() / 3;
  const std::vector<Array> geometry = {make_array("Points", 3, coordinates),
                                       make_array("connectivity", 1, connectivity),
                                       make_array("offsets", 1, offsets), make_array("types", 1, types)};
  // Compression is most of the work: all arrays at the same time, in the order of the file.
  std::vector<const Array *> all;
  for (const std::vector<Array> *arrays : {&global_data, &point_data, &cell_data, &geometry})
    for (const Array &array : *arrays)
      all.push_back(&array);
  std::vector<std::string> packed(all.size());
  parallel_for(all.size(), 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t i = begin; i < end; ++i)
                   packed[i] = compressed(all[i]->bytes);
               });

  std::string xml, appended;
  std::size_t next = 0;
  const auto put_array = [&](const Array &array, const bool global)
  {
    xml += "<DataArray type=\"" + array.type + "\" Name=\"" + array.name + "\" NumberOfComponents=\"" +
           std::to_string(array.n_components) + "\"" + component_names(array.n_components);
    if (global)
      xml += " NumberOfTuples=\"" + std::to_string(array.n_tuples) + "\"";
    xml += " format=\"appended\" offset=\"" + std::to_string(appended.size()) + "\"/>\n";
    appended += packed[next++];
  };
  const auto put_data =
      [&](const std::string &tag, const std::vector<Array> &arrays, const std::size_t n_tuples)
  {
    xml += "<" + tag + ">\n";
    for (const Array &array : arrays)
    {
      if (array.n_tuples != n_tuples)
        throw ComputationError("the field " + array.name + " has " + std::to_string(array.n_tuples) +
                               " values where the picture has " + std::to_string(n_tuples) + " places");
      put_array(array, false);
    }
    xml += "</" + tag + ">\n";
  };

  xml = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
        "byte_order=\"LittleEndian\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n"
        "<UnstructuredGrid>\n<FieldData>\n";
  for (const Array &array : global_data)
    put_array(array, true);
  xml += "</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(n_points) + "\" NumberOfCells=\"" +
         std::to_string(types.size()) + "\">\n";
  put_data("PointData", point_data, n_points);
  put_data("CellData", cell_data, types.size());
  put_data("Points", {geometry[0]}, n_points);
  xml += "<Cells>\n";
  for (unsigned int i = 1; i < geometry.size(); ++i)
    put_array(geometry[i], false);
  xml += "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  return xml + appended + "\n</AppendedData>\n</VTKFile>\n";
}
} // namespace softgrain
