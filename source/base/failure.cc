// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/failure.h>
#include <softgrain/base/interruption.h>
#include <softgrain/base/mistakes.h>

#include <new>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace softgrain
{
Failure kind_of(const std::exception_ptr &failure, std::string &text)
{
  if (!failure)
    return Failure::none;
  try
  {
    std::rethrow_exception(failure);
  }
  catch (const InputErrors &errors)
  {
    text = errors.what();
    return Failure::inputs;
  }
  catch (const InputError &error)
  {
    text = error.what();
    return Failure::input;
  }
  catch (const ComputationError &error)
  {
    text = error.what();
    return Failure::computation;
  }
  catch (const Interrupted &)
  {
    return Failure::interrupted;
  }
  catch (const std::bad_alloc &)
  {
    return Failure::memory;
  }
  catch (const std::exception &error)
  {
    text = error.what();
    return Failure::other;
  }
}

void fail(const Failure kind, const std::string &text)
{
  switch (kind)
  {
  case Failure::input:
    throw InputError(text);
  case Failure::inputs:
  {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
      lines.push_back(line);
    throw InputErrors(lines);
  }
  case Failure::computation:
    throw ComputationError(text);
  case Failure::interrupted:
    throw Interrupted();
  case Failure::memory:
    throw std::bad_alloc();
  default:
    throw std::runtime_error(text);
  }
}
} // namespace softgrain
