// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_model_state_file_h
#define softgrain_model_state_file_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace softgrain
{
/// @name Long lists go through files in pieces of some rows, each of @p width numbers, so that nobody needs
/// them as a whole.
///@{

/// What a piece has at most [numbers].
constexpr std::size_t numbers_of_a_piece = std::size_t(1) << 17;

/// Calls @p work for piece after piece: its first row and the end of its rows.
template <class Work>
void for_pieces(const std::size_t n_rows, const std::size_t width, const Work &work, std::size_t begin = 0)
{
  const std::size_t rows_of_a_piece = std::max<std::size_t>(numbers_of_a_piece / width, 1);
  for (; begin < n_rows; begin = std::min(begin + rows_of_a_piece, n_rows))
    work(begin, std::min(begin + rows_of_a_piece, n_rows));
}
///@}

/// Where a model writes its state: named arrays, slashes make groups.
class StateWriter
{
public:
  /// Puts the rows from @p begin to @p end, without it, to @p rows.
  using Fill = std::function<void(std::size_t begin, std::size_t end, double *rows)>;

  virtual ~StateWriter() = default;

  /// Writes a list that @p fill gives piece by piece, with for_pieces(). All processes call it, and
  /// what is put to the rows of the first one counts.
  virtual void write_rows(const std::string &name, std::size_t n_rows, std::size_t width, const Fill &fill)
  {
    std::vector<double> values(n_rows * width);
    for_pieces(n_rows, width,
               [&](const std::size_t begin, const std::size_t end)
               { fill(begin, end, values.data() + begin * width); });
    write(name, values);
  }

  virtual void write(const std::string &name, const std::vector<double> &values) = 0;
  virtual void write(const std::string &name, const std::vector<std::uint64_t> &values) = 0;
  virtual void write(const std::string &name, const std::string &text) = 0;
};

/// How many numbers a list of a state may have, as whoever reads it says.
class ListSize
{
public:
  /// A list of @p exact numbers.
  ListSize(const std::size_t exact) : unit(exact), several(false) {}
  /// Any number of rows of so many numbers, also none.
  static ListSize rows_of(const std::size_t width) { return ListSize(width, true); }

  bool allows(const std::size_t size) const { return several ? size % unit == 0 : size == unit; }
  /// "12 numbers", "rows of 3 numbers"
  std::string in_words() const;

private:
  ListSize(const std::size_t unit, const bool several) : unit(unit), several(several) {}

  std::size_t unit;
  bool several;
};

/**
 * @brief Where a model reads its state back.
 *
 * Who reads a list says how many numbers it must have, for the file may come from anywhere. A list that is
 * missing or of another type or size is an InputError that names file and list, and so is a number of a file
 * that is none (NaN) or infinite.
 */
class StateReader
{
public:
  /// Is shown the rows from @p begin to @p end, without it.
  using Take = std::function<void(std::size_t begin, std::size_t end, const double *rows)>;

  virtual ~StateReader() = default;

  /// Shows a list of @p n_rows rows of @p width numbers piece by piece.
  void read_rows(const std::string &name, std::size_t n_rows, std::size_t width, const Take &take) const;

  std::vector<double> read_doubles(const std::string &name, ListSize size) const;
  /// @param end of the numbers that are allowed; 0: all are
  std::vector<std::uint64_t>
  read_integers(const std::string &name, ListSize size, std::uint64_t end = 0) const;
  /// Keys of something, each greater than the one before.
  std::vector<std::uint64_t> read_keys(const std::string &name, ListSize size) const;
  std::string read_text(const std::string &name) const { return text(name); }
  virtual bool contains(const std::string &name) const = 0;

  /// Ends the reading of a list whose numbers cannot be. @throw InputError
  [[noreturn]] virtual void refuse(const std::string &name, const std::string &why) const = 0;

protected:
  /// How many numbers a list has.
  virtual std::size_t size(const std::string &name) const = 0;
  virtual void rows(const std::string &name, std::size_t width, const Take &take) const = 0;
  virtual std::vector<double> doubles(const std::string &name) const = 0;
  virtual std::vector<std::uint64_t> integers(const std::string &name) const = 0;
  virtual std::string text(const std::string &name) const = 0;

private:
  void check_size(const std::string &name, std::size_t found, ListSize size) const;
};
} // namespace softgrain

#endif
