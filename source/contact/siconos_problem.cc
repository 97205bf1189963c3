// SPDX-License-Identifier: LGPL-2.1-or-later
// Reader of Siconos's text format (numerics/src/FrictionContact and tools/NumericsMatrix, SparseBlockMatrix).
#include <softgrain/base/exceptions.h>
#include <softgrain/contact/problem_io.h>

#include <fstream>
#include <numeric>

namespace softgrain::contact
{
namespace
{
template <typename T>
T next(std::istream &in, const char *what)
{
  T value;
  if (!(in >> value))
    throw InputError(std::string("cannot read ") + what);
  return value;
}

template <typename T>
std::vector<T> next_values(std::istream &in, const std::size_t n, const char *what)
{
  std::vector<T> values(n);
  for (T &value : values)
    value = next<T>(in, what);
  return values;
}

Eigen::MatrixXd read_dense(std::istream &in, const unsigned int n)
{
  Eigen::MatrixXd W(n, n);
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < n; ++i)
      W(i, j) = next<double>(in, "the dense matrix");
  return W;
}

Eigen::MatrixXd read_sparse_blocks(std::istream &in, const unsigned int n)
{
  const auto n_blocks = next<unsigned int>(in, "the number of blocks");
  const auto n_rows = next<unsigned int>(in, "the number of block rows");
  const auto n_columns = next<unsigned int>(in, "the number of block columns");
  const auto row_end = next_values<unsigned int>(in, n_rows, "the row sizes");
  const auto column_end = next_values<unsigned int>(in, n_columns, "the column sizes");
  const auto filled_rows = next<std::size_t>(in, "filled1");
  const auto filled = next<std::size_t>(in, "filled2");
  const auto row_start = next_values<std::size_t>(in, filled_rows, "the block row offsets");
  const auto column = next_values<std::size_t>(in, filled, "the block columns");
  if (filled_rows != n_rows + 1 || filled != n_blocks || row_start.back() != filled)
    throw InputError("the offsets of the blocks do not fit together");

  Eigen::MatrixXd W = Eigen::MatrixXd::Zero(n, n);
  for (unsigned int row = 0; row < n_rows; ++row)
    for (std::size_t b = row_start[row]; b < row_start[row + 1]; ++b)
    {
      if (next<std::size_t>(in, "the number of a block") != b || column[b] >= n_columns)
        throw InputError("the blocks are not in order");
      const unsigned int i0 = row == 0 ? 0 : row_end[row - 1],
                         j0 = column[b] == 0 ? 0 : column_end[column[b] - 1];
      if (row_end[row] > n || column_end[column[b]] > n)
        throw InputError("a block is outside of the matrix");
      for (unsigned int j = j0; j < column_end[column[b]]; ++j)
        for (unsigned int i = i0; i < row_end[row]; ++i)
          W(i, j) = next<double>(in, "a block");
    }
  return W;
}
} // namespace

SavedProblem load_siconos_problem(const std::string &path)
{
  std::ifstream in(path);
  if (!in)
    throw InputError("cannot open the Siconos problem " + path);
  try
  {
    SavedProblem saved;
    saved.description = "Siconos problem " + path.substr(path.find_last_of('/') + 1);
    saved.problem.n_components = next<unsigned int>(in, "the dimension");
    const auto n_contacts = next<unsigned int>(in, "the number of contacts");
    const auto storage = next<int>(in, "the storage of the matrix");
    const auto n = next<unsigned int>(in, "the rows of the matrix");
    const auto columns = next<unsigned int>(in, "the columns of the matrix");
    if (saved.problem.n_components < 2 || saved.problem.n_components > 3 || columns != n ||
        n != n_contacts * saved.problem.n_components)
      throw InputError("the sizes do not fit together");
    if (storage != 0 && storage != 1)
      throw InputError("the matrix storage " + std::to_string(storage) +
                       " is neither dense (0) nor sparse blocks (1)");
    Eigen::MatrixXd W = storage == 0 ? read_dense(in, n) : read_sparse_blocks(in, n);
    saved.problem.free_velocity = next_values<double>(in, n, "q");
    saved.problem.friction = next_values<double>(in, n_contacts, "mu");
    saved.impulses.assign(n, 0.);
    std::vector<unsigned int> components(n);
    std::iota(components.begin(), components.end(), 0);
    BlockDelassus delassus(n_contacts, saved.problem.n_components);
    delassus.add_block(components, W);
    saved.delassus = std::move(delassus);
    saved.problem.check();
    return saved;
  }
  catch (const InputError &error)
  {
    throw InputError("Siconos problem " + path + ": " + error.what());
  }
}
} // namespace softgrain::contact
