// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_parameters_parameter_file_h
#define softgrain_parameters_parameter_file_h

#include <string>
#include <vector>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
class Mistakes;
struct ParameterSection;

/// "Section/Sub/Key = value" as a user wrote it somewhere.
struct ParameterAssignment
{
  std::vector<std::string> sections;
  std::string key; ///< empty when only the section is named
  std::string value;
  std::string where; ///< "FILE:LINE" or "--set"
};

/**
 * @brief What a parameter file says, before anyone knows which parameters exist.
 *
 * Reading checks the form; apply() checks every name and value against what has been declared. In between,
 * value() and names() let the reader find out which bodies, walls and materials to declare. Files ending in
 * .json are JSON, all others deal.II's .prm format with `include FILE`.
 */
class ParameterFile
{
public:
  /// @throw InputError "FILE:LINE: …" when the file cannot be read or is not well formed.
  explicit ParameterFile(const std::string &file_name);

  /// Reads a file of which what is wrong with single lines is added to @p mistakes, and the others are read.
  /// @throw InputError when it is unknown what they mean: a file that is missing, a section without an end
  ParameterFile(const std::string &file_name, Mistakes &mistakes);

  /// Adds a later word, from the command line: "Section/Sub/Key=value".
  void set(const std::string &assignment);

  /**
   * @brief Parameters that are paths count from the folder of the file in which they stand: relative ones are
   * changed to what leads there from where the program was started. Those of set() count from there already.
   * @param paths "Section/Key"; a value may be a list with commas
   */
  void resolve_paths(const std::vector<std::string> &paths);

  /// What the file says last of a parameter, or @p otherwise.
  std::string
  value(const std::vector<std::string> &sections, const std::string &key, const std::string &otherwise) const;

  /// Where value() comes from, for messages; the file's name when it says nothing.
  std::string where(const std::vector<std::string> &sections, const std::string &key) const;

  /**
   * @brief The list "Names" of a section: what its subsections are called.
   * @throw InputError for a name given twice, of more than 100 characters, or with others than letters,
   * digits,
   * '_', '-'.
   */
  std::vector<std::string> names(const std::string &section) const;

  /**
   * @brief Sets everything in @p prm, where it must be declared.
   *
   * @throw InputErrors with a line for each that cannot be set: "FILE:LINE: 'Section/Key' = 'value' is not
   * allowed: …", or with the nearest known name.
   */
  void apply(dealii::ParameterHandler &prm) const;

  /**
   * @brief Sets what can be set, and adds the rest to @p mistakes.
   * @param unknown not null: names that are not declared are no mistakes, but are noted here, as
   * "FILE:LINE: 'Section/Key' = 'value'"
   */
  void
  apply(dealii::ParameterHandler &prm, Mistakes &mistakes, std::vector<std::string> *unknown = nullptr) const;

  /// A later message about the parameter it quotes first, 'Section/Key', with the place in front; with the
  /// file's name alone when the file does not set it.
  std::string located(const std::string &message) const;

  const std::string &file_name() const { return name; }

private:
  const ParameterAssignment *find(const std::vector<std::string> &sections, const std::string &key) const;

  std::string name;
  std::vector<ParameterAssignment> assignments;
};

/// Sections within sections that a file may open; none of softgrain's goes deeper than five.
constexpr unsigned int max_section_depth = 16;

/// Text of a file without the byte-order mark that some editors write. @throw InputError when @p file_name is
/// missing, a folder, unreadable or not text.
std::string read_text_file(const std::string &file_name);

/// Files on the way from the one that is read to one that it includes, both counted.
constexpr unsigned int max_include_depth = 16;

/// Files that are included altogether: two files that each include the next one twice would be read 2^n
/// times.
constexpr unsigned int max_includes = 200;

/**
 * @brief The assignments of a .prm file: those of the files that it includes first, wherever the includes
 * stand, so that its own, which come later, count more.
 *
 * Lines that say nothing are added to @p mistakes. @throw InputError when it is unknown what the others mean
 */
std::vector<ParameterAssignment> read_prm_file(const std::string &file_name, Mistakes &mistakes);

/// The assignments of a JSON file: objects are sections, lists become "a, b" and lists of lists "a, b; c, d".
/// As with read_prm_file(), @p mistakes are those after which one can go on.
std::vector<ParameterAssignment> read_json_file(const std::string &file_name, Mistakes &mistakes);
} // namespace softgrain

#endif
