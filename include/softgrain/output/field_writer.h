// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_field_writer_h
#define softgrain_output_field_writer_h

#include <softgrain/analysis/snapshot.h>
#include <softgrain/output/late_files.h>

#include <cstdint>
#include <string>
#include <utility>

#include <vector>

namespace softgrain
{
/// What goes into the pictures. Everything is on by default; large runs turn off what they do not look at.
struct FieldOptions
{
  bool points = true;                 ///< material points or primaries with their fields
  bool outlines = true;               ///< bodies as polygons
  bool contacts = true;               ///< contact places with force
  bool walls = true;                  ///< walls as lines
  bool deformation_gradient = true;   ///< F at the points: needed to draw them as deformed cells
  bool extra_fields = true;           ///< history of the law
  unsigned int compression_level = 1; ///< zlib's, 0 to 9; above 1 little is won on floating-point numbers
};

/**
 * @brief Writes `fields.pvd` and `fields/{points,outlines,contacts,walls}-NNNNNN.vtu` for ParaView.
 *
 * Every file appears whole, and `fields.pvd` is replaced after the files it names: a running output can be
 * opened at any time. Files of an earlier run in the same folder are removed at the first write().
 */
class FieldWriter
{
public:
  /// @param directory the output folder; made when missing
  explicit FieldWriter(const std::string &directory, const FieldOptions &options = FieldOptions());

  /**
   * @brief Goes on with the series found in the folder: keeps its entries up to @p time [s], drops later
   * ones.
   *
   * An entry at @p time itself is kept, and a write() at that time replaces it. Without a `fields.pvd` the
   * series starts empty.
   * @throw InputError when `fields.pvd` is not one of ours.
   */
  void resume(double time);

  /// Adds one frame; frames at this time or later are replaced by it. @throw ComputationError when the disk
  /// refuses.
  void write(const Snapshot<2> &snapshot);
  /// Writes a state in space, where outlines are surfaces of triangles, with places that carry force in a
  /// file of their own; walls are not drawn.
  void write(const Snapshot<3> &snapshot);

  /// Waits for the disk to have all frames that were written. @throw ComputationError when it refuses.
  void bring_to_disk() { late.bring_to_disk(); }

  /// Frames in `fields.pvd`.
  std::size_t n_frames() const { return frames.size(); }

private:
  struct Frame
  {
    double time = 0;
    std::vector<std::pair<std::string, std::string>> parts; ///< name; file, relative to the folder
  };

  /// Begins a frame. @return its number, for the names of its files
  std::string begin_frame(double time);
  /// Writes a file of the frame.
  template <class Fill>
  void
  put(Frame &frame, const std::string &number, const std::string &part, std::uint64_t step, const Fill &fill);
  /// Writes the files of a frame, for which @p parts calls put_part(name, fill) each.
  template <int dim, class Parts>
  void write_frame(const Snapshot<dim> &snapshot, const Parts &parts);
  void write_index();
  void remove_stale_files() const;

  std::string directory;
  FieldOptions options;
  std::vector<Frame> frames;
  LateFiles late;
  bool stale_files_removed = false;
};

/// Removes the pictures of a run from its output folder, and nothing else.
void remove_pictures(const std::string &directory);
} // namespace softgrain

#endif
