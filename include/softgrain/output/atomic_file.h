// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_atomic_file_h
#define softgrain_output_atomic_file_h

#include <string>

namespace softgrain
{
class LateFiles;

/**
 * @brief A file that appears under its name whole or not at all, whatever interrupts the program.
 *
 * The content is written under temporary_path(), in the same folder; commit() brings it to the disk and
 * renames it. A file that is never committed leaves nothing behind but, after a crash, `NAME.part`, which the
 * next attempt overwrites.
 */
class AtomicFile
{
public:
  /// Creates the folder of @p final_path when it is missing.
  explicit AtomicFile(const std::string &final_path);
  /// Removes the temporary file when it was not committed.
  ~AtomicFile();
  AtomicFile(const AtomicFile &) = delete;
  AtomicFile &operator=(const AtomicFile &) = delete;

  /// Where to write; closed by the caller before commit().
  const std::string &temporary_path() const { return part_path; }
  const std::string &final_path() const { return whole_path; }

  /// Writes the whole content to the temporary path.
  void write(const std::string &content);

  /**
   * @brief Puts the file in its place: fsync of the file, rename, fsync of the folder.
   * @throw ComputationError with the reason when the disk refuses.
   */
  void commit();

  /// Brings what was written to the disk while the file has no name yet. @throw ComputationError as commit().
  void sync();

  /// Puts the file in its place by a rename alone, and notes it among those that are brought to the disk
  /// later.
  void commit(LateFiles &later);

private:
  void rename();

  std::string whole_path;
  std::string part_path;
  bool committed = false;
};

/// write() and commit() in one.
void write_file_atomically(const std::string &path, const std::string &content);
/// Writes and renames the file; the disk is waited for later.
void write_file_atomically(const std::string &path, const std::string &content, LateFiles &later);

/// fsync of a file. @throw ComputationError with the reason when the disk refuses
void bring_file_to_disk(const std::string &path);
/// fsync of a folder, so that its names are on the disk.
void bring_folder_to_disk(const std::string &path);
/// The folder that a file is in.
std::string folder_of_file(const std::string &path);
} // namespace softgrain

#endif
