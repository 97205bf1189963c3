// SPDX-License-Identifier: LGPL-2.1-or-later
// Reader of Siconos's text format (numerics/src/FrictionContact and tools/NumericsMatrix, SparseBlockMatrix).
#include <softgrain/base/exceptions.h>
#include <softgrain/contact/problem_io.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <numeric>
#include <sstream>

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
  std::vector<T> values;
  while (values.size() < n) // not made at once: n may be damaged, and the file ends sooner
    values.push_back(next<T>(in, what));
  return values;
}

/// A matrix of so many rows is kept whole; more of them do not fit into memory.
constexpr unsigned int max_rows = 20000;

void check_rows(const unsigned int n)
{
  if (n > max_rows)
    throw InputError("the matrix has " + std::to_string(n) + " rows, at most " + std::to_string(max_rows) +
                     " are read");
}

/// Reads a dense matrix; @p n_after values follow it. Siconos writes the sizes a second time before the
/// entries, files of other programs do not: the number of values that are left tells.
Eigen::MatrixXd read_dense(std::istream &in, const unsigned int n, const std::size_t n_after)
{
  const auto begin = in.tellg();
  std::size_t n_left = 0;
  for (double value; in >> value;)
    ++n_left;
  in.clear();
  in.seekg(begin);
  if (n_left < std::size_t(n) * n)
    throw InputError("cannot read the dense matrix");
  if (n_left >= std::size_t(n) * n + n_after + 2 &&
      (next<double>(in, "the repeated rows") != n || next<double>(in, "the repeated columns") != n))
    throw InputError("there are more numbers than the matrix, q and mu need");
  Eigen::MatrixXd W(n, n);
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < n; ++i)
      W(i, j) = next<double>(in, "the dense matrix");
  return W;
}

std::string next_line(std::istream &in, const char *what)
{
  std::string line;
  if (!std::getline(in >> std::ws, line))
    throw InputError(std::string("cannot read ") + what);
  return line;
}

/// The matrix as CSparse prints it: a line of its version, one of sizes, then triplets "i j : value", or
/// columns (rows, when the origin says so) of lines "i : value".
Eigen::MatrixXd read_sparse(std::istream &in, const unsigned int n)
{
  constexpr unsigned int triplet = 1, by_row = 3; // 2: by column
  const auto origin = next<unsigned int>(in, "the kind of the sparse matrix");
  if (origin < triplet || origin > by_row)
    throw InputError("the kind of the sparse matrix, " + std::to_string(origin) +
                     ", is neither triplets (1) nor columns (2) nor rows (3)");
  next_line(in, "the version of CSparse");
  const std::string sizes = next_line(in, "the sizes of the sparse matrix");
  unsigned long n_rows = 0, n_columns = 0, n_allocated = 0, n_entries = 0;
  const char *const format = "%lu-by-%lu, nzmax: %lu nnz: %lu";
  const std::string with_word = std::string("triplet: ") + format;
  if (std::sscanf(sizes.c_str(), origin == triplet ? with_word.c_str() : format, &n_rows, &n_columns,
                  &n_allocated, &n_entries) != 4 ||
      n_rows != n || n_columns != n)
    throw InputError("the sizes of the sparse matrix are not understood: '" + sizes + "'");
  Eigen::MatrixXd W = Eigen::MatrixXd::Zero(n, n);
  unsigned long column = 0;
  for (unsigned long entry = 0; entry < n_entries;)
  {
    const std::string line = next_line(in, "an entry of the sparse matrix");
    unsigned long i = 0;
    double value = 0.;
    if (origin != triplet && std::sscanf(line.c_str(), "col %lu : locations", &column) == 1)
      continue;
    if ((origin == triplet ? std::sscanf(line.c_str(), "%lu %lu : %lg", &i, &column, &value) != 3
                           : std::sscanf(line.c_str(), "%lu : %lg", &i, &value) != 2) ||
        i >= n || column >= n)
      throw InputError("'" + line + "' is not an entry of the sparse matrix");
    (origin == by_row ? W(column, i) : W(i, column)) += value; // of equal places the sum counts
    ++entry;
  }
  // Empty columns may follow the last entry.
  for (auto here = in.tellg(); in >> std::ws && in.peek() == 'c'; here = in.tellg())
    next_line(in, "a column");
  return W;
}

/**
 * Sets both triangles to their mean. Entries of sparse files have six digits, and W computed as a product
 * differs by rounding; what differs by more is another matrix.
 */
void make_symmetric(Eigen::MatrixXd &W)
{
  if (W.size() == 0)
    return;
  if (!W.allFinite())
    throw InputError("the matrix has an entry that is no finite number");
  constexpr double allowed = 1e-5;
  const double largest = W.cwiseAbs().maxCoeff(), difference = (W - W.transpose()).cwiseAbs().maxCoeff();
  if (!(difference <= allowed * largest))
  {
    std::ostringstream text;
    text << "the matrix is not symmetric: two entries differ by " << difference << ", the largest is "
         << largest << "; " << allowed << " of it is allowed";
    throw InputError(text.str());
  }
  W = (0.5 * (W + W.transpose())).eval();
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
  if (filled_rows != std::size_t(n_rows) + 1 || filled != n_blocks || row_start.back() != filled ||
      !std::is_sorted(row_start.begin(), row_start.end()))
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
        n != std::size_t(n_contacts) * saved.problem.n_components)
      throw InputError("the sizes do not fit together");
    check_rows(n);
    if (storage < 0 || storage > 2)
      throw InputError("the matrix storage " + std::to_string(storage) +
                       " is neither dense (0) nor sparse blocks (1) nor sparse (2)");
    Eigen::MatrixXd W = storage == 0   ? read_dense(in, n, n + n_contacts)
                        : storage == 1 ? read_sparse_blocks(in, n)
                                       : read_sparse(in, n);
    make_symmetric(W);
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
