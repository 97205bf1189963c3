// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_failure_h
#define softgrain_base_failure_h

#include <exception>
#include <string>

namespace softgrain
{
/// What one process may throw, so that the others throw the same.
enum class Failure
{
  none,
  input,
  inputs, ///< several mistakes, a line each
  computation,
  interrupted,
  memory,
  other
};

/// The kind of an exception, null: none. @param text what it says
Failure kind_of(const std::exception_ptr &failure, std::string &text);

/// Throws an exception of this kind that says @p text.
[[noreturn]] void fail(Failure kind, const std::string &text);
} // namespace softgrain

#endif
