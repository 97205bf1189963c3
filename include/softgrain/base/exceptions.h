// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_exceptions_h
#define softgrain_base_exceptions_h

#include <stdexcept>
#include <string>

namespace softgrain
{
/**
 * @brief What the user wrote cannot be run: one clear line, exit code 2.
 *
 * The message says what is wrong, the value found, what is allowed and where.
 */
class InputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/**
 * @brief The computation failed: one clear line, the last good state is kept, exit code 1.
 *
 * The message names body, place, time and the parameter to change.
 */
class ComputationError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
} // namespace softgrain

#endif
