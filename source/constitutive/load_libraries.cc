// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/constitutive/law_registry.h>
#include <softgrain/constitutive/load_libraries.h>

#include <dlfcn.h>

#include <filesystem>

namespace softgrain::constitutive
{
void load_libraries(const std::vector<std::string> &paths)
{
  for (const std::string &path : paths)
  {
    std::error_code ignored;
    const bool is_file = std::filesystem::is_regular_file(path, ignored);
    const std::string file = is_file ? std::filesystem::absolute(path).string() : path;
    // Everything is resolved now: a missing symbol is an input error here, not a crash in the middle of a
    // run. The handle stays open, because the laws live in the library.
    if (dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL) == nullptr)
    {
      const char *reason = dlerror();
      throw InputError("Additional shared libraries: '" + path +
                       "' cannot be loaded: " + (reason == nullptr ? "no reason given" : reason));
    }
    try
    {
      check_registrations();
    }
    catch (const InputError &error)
    {
      throw InputError("Additional shared libraries: '" + path + "': " + error.what());
    }
  }
}
} // namespace softgrain::constitutive
