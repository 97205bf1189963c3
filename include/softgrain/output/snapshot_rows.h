// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_snapshot_rows_h
#define softgrain_output_snapshot_rows_h

#include <softgrain/base/exceptions.h>
#include <softgrain/output/hdf5_reader.h>
#include <softgrain/output/hdf5_writer.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// Members of many items as the rows of one array of a file, both ways.
namespace softgrain::snapshot_rows
{
/// A group of a file that is being written: names count from there.
struct Hdf5Group
{
  Hdf5Writer &file;
  const std::string group; ///< with a slash at its end; empty: the file itself

  template <typename Values>
  void write(const std::string &name, const Values &values, const unsigned int n_columns) const
  {
    file.write(group + name, values, n_columns);
  }
  template <typename Values>
  void write(const std::string &name, const Values &values) const
  {
    file.write(group + name, values);
  }
};

// Every type of the snapshot as a row of numbers, both ways.
inline void put(std::vector<double> &row, const double value)
{
  row.push_back(value);
}
template <int dim>
void put(std::vector<double> &row, const dealii::Tensor<1, dim> &value)
{
  for (unsigned int d = 0; d < dim; ++d)
    row.push_back(value[d]);
}
/// xx, yy, xy; in space xx, yy, zz, xy, xz, yz.
template <int dim>
void put(std::vector<double> &row, const dealii::SymmetricTensor<2, dim> &value)
{
  for (unsigned int d = 0; d < dim; ++d)
    row.push_back(value[d][d]);
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = i + 1; j < dim; ++j)
      row.push_back(value[i][j]);
}
template <int dim>
void put(std::vector<double> &row, const dealii::Tensor<2, dim> &value)
{
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = 0; j < dim; ++j)
      row.push_back(value[i][j]);
}
inline void take(const double *row, double &value)
{
  value = row[0];
}
template <int dim>
void take(const double *row, dealii::Tensor<1, dim> &value)
{
  for (unsigned int d = 0; d < dim; ++d)
    value[d] = row[d];
}
template <int dim>
void take(const double *row, dealii::SymmetricTensor<2, dim> &value)
{
  for (unsigned int d = 0; d < dim; ++d)
    value[d][d] = *row++;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = i + 1; j < dim; ++j)
      value[i][j] = *row++;
}
template <int dim>
void take(const double *row, dealii::Tensor<2, dim> &value)
{
  for (unsigned int i = 0; i < dim * dim; ++i)
    value[i / dim][i % dim] = row[i];
}

/// Numbers per row of a type.
template <typename Value>
unsigned int width()
{
  std::vector<double> row;
  put(row, Value());
  return row.size();
}

/// One array of an HDF5 file, a row for what @p value gives of every item; read_rows() is the way back.
template <typename Item, typename Function>
void write_rows(const Hdf5Group &file,
                const std::string &name,
                const std::vector<Item> &items,
                const Function &value)
{
  std::vector<double> rows;
  for (const Item &item : items)
    put(rows, value(item));
  file.write(name, rows, width<std::decay_t<decltype(value(std::declval<const Item &>()))>>());
}

template <typename Item>
void write_rows(const Hdf5Group &file, const std::string &name, const std::vector<Item> &items)
{
  write_rows(file, name, items, [](const Item &item) { return item; });
}

template <typename Item, typename Function>
void read_rows(const Hdf5Reader &file,
               const std::string &name,
               std::vector<Item> &items,
               const Function &place)
{
  using Value = std::decay_t<decltype(place(items[0]))>;
  const std::vector<double> rows = file.read_doubles(name);
  const unsigned int columns = width<Value>();
  items.resize(rows.size() / columns);
  for (std::size_t i = 0; i < items.size(); ++i)
    take(rows.data() + i * columns, place(items[i]));
}

template <typename Item>
void read_rows(const Hdf5Reader &file, const std::string &name, std::vector<Item> &items)
{
  read_rows(file, name, items, [](Item &item) -> Item & { return item; });
}

template <typename Item, typename Function>
void write_indices(const Hdf5Group &file,
                   const std::string &name,
                   const std::vector<Item> &items,
                   const Function &value)
{
  std::vector<std::uint64_t> indices;
  for (const Item &item : items)
    indices.push_back(value(item));
  file.write(name, indices);
}

template <typename Item, typename Function>
void read_indices(const Hdf5Reader &file,
                  const std::string &name,
                  std::vector<Item> &items,
                  const Function &place)
{
  const std::vector<std::uint64_t> indices = file.read_integers(name);
  items.resize(indices.size());
  for (std::size_t i = 0; i < items.size(); ++i)
    place(items[i]) = static_cast<unsigned int>(indices[i]);
}
} // namespace softgrain::snapshot_rows

#endif
