// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/plugin_interface.h>
#include <softgrain/constitutive/law_registry.h>
#include <softgrain/constitutive/load_libraries.h>

#include <dlfcn.h>
#include <link.h>

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
    if (is_file)
      check_plugin_interface(file, path);
    // Everything is resolved now: a missing symbol is an input error here, not a crash in the middle of a
    // run. The handle stays open, because the laws live in the library.
    void *const handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr)
    {
      const char *reason = dlerror();
      throw InputError("Additional shared libraries: '" + path +
                       "' cannot be loaded: " + (reason == nullptr ? "no reason given" : reason));
    }
    // One that the loader has found by its name.
    if (link_map *found = nullptr; !is_file && dlinfo(handle, RTLD_DI_LINKMAP, &found) == 0)
      check_plugin_interface(found->l_name, path);
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
