// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_mistakes_h
#define softgrain_base_mistakes_h

#include <softgrain/base/exceptions.h>

#include <string>
#include <vector>

namespace softgrain
{
/// Several mistakes in what the user wrote, told at once; what() has a line for each.
class InputErrors : public InputError
{
public:
  explicit InputErrors(const std::vector<std::string> &lines);

  const std::vector<std::string> &lines() const { return each; }

private:
  std::vector<std::string> each;
};

/**
 * @brief Mistakes of a user that are collected, so that one run of the program tells all of them.
 *
 * What depends on something that is wrong is not looked at: it would only be a second complaint about the
 * same.
 */
class Mistakes
{
public:
  /**
   * @brief Keeps @p message as one line; what is there already is not kept twice.
   * @param path what it is about: "Section/Key", or "Section/" for something in that section; empty: unknown
   */
  void add(const std::string &message, const std::string &path = "");

  /// No mistake, but what belongs to @p path may be another than the user wants; see concern().
  void doubt(const std::string &path);

  /// Keeps the message of @p error, or all of an InputErrors.
  void add(const InputError &error);

  /// Does @p work and keeps an InputError that it throws. @return whether there was none
  template <typename Work>
  bool attempt(const Work &work)
  {
    try
    {
      work();
      return true;
    }
    catch (const InputError &error)
    {
      add(error);
      return false;
    }
  }

  /// Whether @p message quotes a parameter of a part of the file, 'Bodies/left' or 'Contact', in which
  /// something is wrong already: then it may be nothing but a consequence of that.
  bool concern(const std::string &message) const;

  bool empty() const { return messages.empty(); }
  const std::vector<std::string> &lines() const { return messages; }

  /// @throw InputErrors when there are any: the first ten, then how many more there are
  void end() const;

private:
  std::vector<std::string> messages;
  std::vector<std::string> parts; ///< in which something is wrong
};
} // namespace softgrain

#endif
