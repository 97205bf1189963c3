// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/python_script.h>
#include <softgrain/base/config.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/base/nearest_name.h>

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>

namespace softgrain
{
namespace fs = std::filesystem;

void run_python_script(const std::string &name, const std::vector<std::string> &arguments)
{
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const std::vector<std::string> folders = {
      (program.parent_path().parent_path() / SOFTGRAIN_INSTALLED_PYTHON_DIR).lexically_normal().string(),
      SOFTGRAIN_SOURCE_PYTHON_DIR};
  std::string script;
  for (const std::string &folder : folders)
    if (script.empty() && fs::exists(fs::path(folder) / (name + ".py"), error))
      script = (fs::path(folder) / (name + ".py")).string();
  if (script.empty())
    throw InputError("the script '" + name + ".py' is missing; looked in " + join(folders));

  // What scripts start is this very program, unless the user has named another.
  if (!error && !program.empty())
    setenv("SOFTGRAIN", program.c_str(), 0);
  std::vector<std::string> words = {SOFTGRAIN_PYTHON, script};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char *> argv;
  for (std::string &word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);
  std::cout << std::flush;
  execvp(argv[0], argv.data());
  throw InputError(std::string("'") + SOFTGRAIN_PYTHON + "' cannot be started: " + std::strerror(errno));
}
} // namespace softgrain
