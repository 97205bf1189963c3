// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_hdf5_writer_h
#define softgrain_output_hdf5_writer_h

#include <softgrain/output/hdf5_file.h>

#include <memory>

namespace softgrain
{
class Hdf5DiskFile;

/// An HDF5 file that is written as it goes, and whole after close(). Missing groups are created.
class Hdf5Writer : public Hdf5File
{
public:
  /// Replaces what is there.
  /// @param compression_level of the deflate filter for large arrays; 0: stored as they are
  explicit Hdf5Writer(const std::string &path, unsigned int compression_level = 0);
  ~Hdf5Writer();

  /// @name Arrays of @p n_columns numbers per row; one column makes a one-dimensional array.
  ///@{
  void write(const std::string &name, const std::vector<double> &values, unsigned int n_columns = 1);
  void write(const std::string &name, const std::vector<std::uint64_t> &values, unsigned int n_columns = 1);
  void write(const std::string &name, const std::string &text);
  void write(const std::string &name, const std::vector<std::string> &texts);
  /// An array of one column whose numbers write_piece() gives; they are not compressed.
  void create_array(const std::string &name, std::size_t size);
  void write_piece(const std::string &name, std::size_t begin, std::size_t size, const double *values);
  ///@}

  /// @name Attributes of an existing array or group; "/" is the file itself.
  ///@{
  void write_attribute(const std::string &object, const std::string &name, double value);
  void write_attribute(const std::string &object, const std::string &name, std::uint64_t value);
  void write_attribute(const std::string &object, const std::string &name, const std::string &text);
  ///@}

  /// A link to an object of another file, whose path is relative to the folder of this one.
  void link(const std::string &name, const std::string &file, const std::string &object);

  /// Brings the file to the disk and closes it. @param sealed with a checksum behind it, see seal.h
  /// @throw ComputationError with the reason of the system
  void close(bool sealed = false);

private:
  void put(const std::string &name,
           std::int64_t type,
           const std::vector<std::uint64_t> &sizes,
           const void *values,
           unsigned int level);

  std::unique_ptr<Hdf5DiskFile> disk;
  const unsigned int compression_level;
};
} // namespace softgrain

#endif
