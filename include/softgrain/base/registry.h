// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_registry_h
#define softgrain_base_registry_h

#include <softgrain/base/exceptions.h>
#include <softgrain/base/nearest_name.h>
#include <softgrain/base/plugin_interface.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace softgrain
{
/// Keeps the message of a registration that failed, for check_registrations() to report.
void note_failed_registration(const std::string &message);

/// @throw InputError naming every registration that failed since the last call (a name used twice).
void check_registrations();

/**
 * @brief Names and factories of one family of replaceable parts (laws, measures, models, …).
 *
 * A member registers itself where it is defined:
 * @code
 * const bool registered = Registry<Law<2>>::instance().add("name", "one paragraph", [] { … });
 * @endcode
 * The table is filled before main() or when a shared library is loaded, and only read afterwards.
 */
template <typename Base>
class Registry
{
public:
  using Factory = std::function<std::unique_ptr<Base>()>;

  struct Entry
  {
    std::string description;
    Factory factory;
  };

  /// The one table of this family.
  static Registry &instance();

  /// @return whether the name was free, so that it can initialise a namespace-scope constant. When it was
  /// not, this is kept for check_registrations(): it happens before main() or inside dlopen(), where an
  /// exception would end the program without a message.
  bool add(const std::string &name, const std::string &description, Factory factory)
  {
    const bool free = entries.emplace(name, Entry{description, std::move(factory)}).second;
    if (!free)
      note_failed_registration("registered twice: " + name);
    return free;
  }

  /// Registered names in alphabetical order.
  std::vector<std::string> names() const
  {
    std::vector<std::string> result;
    for (const auto &entry : entries)
      result.push_back(entry.first);
    return result;
  }

  /// "a|b|c", what a parameter that selects a member may say (dealii::Patterns::Selection).
  std::string choice() const
  {
    std::string result;
    for (const auto &entry : entries)
      result += (result.empty() ? "" : "|") + entry.first;
    return result;
  }

  /// "a: what it is; b: what it is.", for the documentation of such a parameter.
  std::string choice_in_words() const
  {
    std::string result;
    for (const auto &entry : entries)
      result += (result.empty() ? "" : "; ") + entry.first + ": " + entry.second.description;
    return result + ".";
  }

  const std::string &description(const std::string &name) const { return find(name).description; }

  /// @throw InputError with the known names and the nearest one when @p name is unknown.
  std::unique_ptr<Base> create(const std::string &name) const { return find(name).factory(); }

private:
  const Entry &find(const std::string &name) const
  {
    const auto entry = entries.find(name);
    if (entry != entries.end())
      return entry->second;
    const std::string near = nearest_name(name, names());
    throw InputError("'" + name + "' is not known; known are: " + join(names()) +
                     (near.empty() ? "" : " (did you mean '" + near + "'?)"));
  }

  std::map<std::string, Entry> entries;
};
} // namespace softgrain

/// Defines the one table of a family; used once, in a source file of the library, so that plugins share it.
#define SOFTGRAIN_DEFINE_REGISTRY(...)                                                                       \
  template <>                                                                                                \
  softgrain::Registry<__VA_ARGS__> &softgrain::Registry<__VA_ARGS__>::instance()                             \
  {                                                                                                          \
    static softgrain::Registry<__VA_ARGS__> table;                                                           \
    return table;                                                                                            \
  }

#endif
