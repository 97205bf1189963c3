// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_parameters_parameter_tree_h
#define softgrain_parameters_parameter_tree_h

#include <string>
#include <vector>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
/// One declared parameter.
struct ParameterEntry
{
  std::string name;
  std::string value;
  std::string default_value;
  std::string documentation;
  std::string pattern; ///< deal.II's machine description, see allowed_in_words()
};

/**
 * @brief What a ParameterHandler has declared, as a tree that can be walked: deal.II's own cannot.
 */
struct ParameterSection
{
  std::string name; ///< empty at the top
  std::vector<ParameterEntry> entries;
  std::vector<ParameterSection> sections;

  /// The parameter or section of that name right here, or a null pointer.
  const ParameterEntry *entry(const std::string &name) const;
  const ParameterSection *section(const std::string &name) const;

  std::vector<std::string> entry_names() const;
  std::vector<std::string> section_names() const;
};

/// Everything declared in @p prm, in the order of declaration; @p prm must stand at its top.
ParameterSection parameter_tree(const dealii::ParameterHandler &prm);

/// What a pattern allows, for a user: "a number of at least 0".
std::string allowed_in_words(const std::string &pattern);

/// The words to choose from when the pattern is a choice, else nothing.
std::vector<std::string> choices(const std::string &pattern);

/// "Section/Sub/Key".
std::string parameter_path(const std::vector<std::string> &sections, const std::string &key);
} // namespace softgrain

#endif
