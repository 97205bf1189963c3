// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_hdf5_file_h
#define softgrain_output_hdf5_file_h

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace softgrain
{
class Hdf5DiskFile;

/**
 * @brief An HDF5 file with arrays of numbers and texts in groups, used by one process.
 *
 * A file that is created is written as it goes, and whole after close().
 * Slashes in names make groups; missing groups are created. Errors of writing are ComputationErrors, errors
 * of reading InputErrors; both name file and array. HDF5 itself prints nothing.
 */
class Hdf5File
{
public:
  enum class Mode
  {
    create, ///< replaces what is there
    read
  };

  /// @param compression_level of the deflate filter for large arrays; 0: stored as they are
  Hdf5File(const std::string &path, Mode mode, unsigned int compression_level = 0);
  ~Hdf5File();
  Hdf5File(const Hdf5File &) = delete;
  Hdf5File &operator=(const Hdf5File &) = delete;

  /// The path it was opened with.
  const std::string &name() const { return path; }

  /// @name Arrays of @p n_columns numbers per row; one column makes a one-dimensional array.
  ///@{
  void write(const std::string &name, const std::vector<double> &values, unsigned int n_columns = 1);
  void write(const std::string &name, const std::vector<std::uint64_t> &values, unsigned int n_columns = 1);
  void write(const std::string &name, const std::string &text);
  void write(const std::string &name, const std::vector<std::string> &texts);
  /// An array of one column whose numbers write_piece() gives; they are not compressed.
  void create_array(const std::string &name, std::size_t size);
  void write_piece(const std::string &name, std::size_t begin, std::size_t size, const double *values);
  std::vector<double> read_doubles(const std::string &name) const;
  std::vector<std::uint64_t> read_integers(const std::string &name) const;
  /// A part of an array of one column, from its number @p begin on.
  void read_piece(const std::string &name, std::size_t begin, std::size_t size, double *values) const;
  /// How many numbers an array has.
  std::size_t size(const std::string &name) const;
  std::string read_text(const std::string &name) const;
  std::vector<std::string> read_texts(const std::string &name) const;
  ///@}

  /// @name Attributes of an existing array or group; "/" is the file itself.
  ///@{
  void write_attribute(const std::string &object, const std::string &name, double value);
  void write_attribute(const std::string &object, const std::string &name, std::uint64_t value);
  void write_attribute(const std::string &object, const std::string &name, const std::string &text);
  double read_double_attribute(const std::string &object, const std::string &name) const;
  std::uint64_t read_integer_attribute(const std::string &object, const std::string &name) const;
  std::string read_text_attribute(const std::string &object, const std::string &name) const;
  bool has_attribute(const std::string &object, const std::string &name) const;
  ///@}

  /// A link to an object of another file, whose path is relative to the folder of this one.
  void link(const std::string &name, const std::string &file, const std::string &object);

  bool contains(const std::string &name) const;
  /// Names of all arrays of the file, in groups too; not those behind links to other files.
  std::vector<std::string> array_names() const;
  /// Number type of an array: 'd' double, 'u' unsigned integer, 't' text, '?' another.
  char array_type(const std::string &name) const;
  /// How many values an array of any type has.
  std::size_t array_size(const std::string &name) const;

  /// Brings a created file to the disk and closes it. @param sealed with a checksum behind it, see seal.h
  /// @throw ComputationError with the reason of the system
  void close(bool sealed = false);

private:
  void put(const std::string &name,
           std::int64_t type,
           const std::vector<std::uint64_t> &sizes,
           const void *values,
           unsigned int level);

  std::string path;
  std::unique_ptr<Hdf5DiskFile> disk; ///< null: it is only read
  std::int64_t file = -1;             ///< HDF5's hid_t, whose header stays out of ours
  unsigned int compression_level;
};
} // namespace softgrain

#endif
