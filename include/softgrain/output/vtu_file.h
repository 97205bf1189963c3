// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_vtu_file_h
#define softgrain_output_vtu_file_h

#include <deal.II/base/point.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace softgrain
{
/**
 * @brief One VTK XML file of an unstructured grid: points, lines and polygons with data on points and cells.
 *
 * deal.II's DataOutBase writes neither polygons nor data on cells nor integers, which outlines need; hence
 * this small writer. Arrays are appended raw, compressed by zlib, as VTK's own writer does.
 */
class VtuFile
{
public:
  /// Cell types in VTK's numbering.
  enum class Cell : std::uint8_t
  {
    vertex = 1,
    line = 3,
    poly_line = 4,
    triangle = 5,
    polygon = 7
  };

  /// @param compression_level zlib's, 0 to 9
  explicit VtuFile(unsigned int compression_level);

  /// Adds a cell over new points of its own.
  template <int dim>
  void add_cell(Cell type, const std::vector<dealii::Point<dim>> &vertices);
  /// Every point a cell.
  template <int dim>
  void add_vertices(const std::vector<dealii::Point<dim>> &points);
  /// Triangles over new points, which they share. @param triangles numbers of points, three each
  void add_triangles(const std::vector<dealii::Point<3>> &points,
                     const std::vector<std::array<unsigned int, 3>> &triangles);

  /// @name Data: one tuple of @p n_components per point or per cell, stored one after the other.
  ///@{
  void add_point_data(const std::string &name, unsigned int n_components, const std::vector<float> &values);
  void add_point_data(const std::string &name, const std::vector<std::int32_t> &values);
  void add_cell_data(const std::string &name, unsigned int n_components, const std::vector<double> &values);
  void add_cell_data(const std::string &name, const std::vector<std::int32_t> &values);
  void add_global(const std::string &name, double value);
  ///@}

  /// The whole file. @throw ComputationError when an array has not the length of its points or cells.
  std::string text() const;

private:
  struct Array
  {
    std::string name;
    std::string type;          ///< VTK's name of the number type
    unsigned int n_components; ///< per tuple
    std::size_t n_tuples;
    std::string bytes;
  };

  template <int dim>
  void add_point(const dealii::Point<dim> &point);
  template <typename Number>
  static Array
  make_array(const std::string &name, unsigned int n_components, const std::vector<Number> &values);
  std::string compressed(const std::string &bytes) const;

  unsigned int compression_level;
  std::vector<double> coordinates; ///< three per point
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> offsets;
  std::vector<std::uint8_t> types;
  std::vector<Array> point_data;
  std::vector<Array> cell_data;
  std::vector<Array> global_data;
};
} // namespace softgrain

#endif
