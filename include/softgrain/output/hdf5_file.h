// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_hdf5_file_h
#define softgrain_output_hdf5_file_h

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace softgrain
{
/**
 * @brief An HDF5 file with arrays of numbers and texts in groups, used by one process: what can be asked of
 * it while it is written as well as when it is read.
 *
 * Slashes in names make groups. Errors of writing are ComputationErrors, errors of reading InputErrors; both
 * name file and array. HDF5 itself prints nothing.
 */
class Hdf5File
{
public:
  Hdf5File(const Hdf5File &) = delete;
  Hdf5File &operator=(const Hdf5File &) = delete;

  /// The path it was opened with.
  const std::string &name() const { return path; }
  bool contains(const std::string &name) const;
  /// Names of all arrays of the file, in groups too; not those behind links to other files.
  std::vector<std::string> array_names() const;
  /// Number type of an array: 'd' double, 'u' unsigned integer, 't' text, '?' another.
  char array_type(const std::string &name) const;
  /// How many values an array of any type has.
  std::size_t array_size(const std::string &name) const;

protected:
  explicit Hdf5File(const std::string &path);
  ~Hdf5File();

  const std::string path;
  std::int64_t file = -1; ///< HDF5's hid_t, whose header stays out of ours
};
} // namespace softgrain

#endif
