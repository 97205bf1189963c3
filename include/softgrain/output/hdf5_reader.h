// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_hdf5_reader_h
#define softgrain_output_hdf5_reader_h

#include <softgrain/output/hdf5_file.h>

namespace softgrain
{
/// An HDF5 file that is there, to be read.
class Hdf5Reader : public Hdf5File
{
public:
  /// @throw InputError when it is no such file
  explicit Hdf5Reader(const std::string &path);

  std::vector<double> read_doubles(const std::string &name) const;
  std::vector<std::uint64_t> read_integers(const std::string &name) const;
  /// A part of an array of one column, from its number @p begin on.
  void read_piece(const std::string &name, std::size_t begin, std::size_t size, double *values) const;
  /// How many numbers an array has.
  std::size_t size(const std::string &name) const;
  std::string read_text(const std::string &name) const;
  std::vector<std::string> read_texts(const std::string &name) const;

  /// @name Attributes of an array or group; "/" is the file itself.
  ///@{
  double read_double_attribute(const std::string &object, const std::string &name) const;
  std::uint64_t read_integer_attribute(const std::string &object, const std::string &name) const;
  std::string read_text_attribute(const std::string &object, const std::string &name) const;
  bool has_attribute(const std::string &object, const std::string &name) const;
  ///@}
};
} // namespace softgrain

#endif
