// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/plugin_interface.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace softgrain
{
void check_plugin_interface(const std::string &file, const std::string &name)
{
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (bytes.compare(0, 4, "\177ELF") != 0 || bytes.find("note_failed_registration") == std::string::npos)
    return; // no library, as the loader will say, or one without parts
  const std::string mark = plugin_interface_mark, ours = SOFTGRAIN_PLUGIN_INTERFACE;
  const std::string beginning = mark.substr(0, mark.size() - ours.size() - 1);
  const std::size_t place = bytes.find(beginning);
  std::string theirs = "unnamed";
  if (place != std::string::npos)
  {
    const std::size_t begin = place + beginning.size();
    theirs = bytes.substr(begin, std::min<std::size_t>(bytes.find('.', begin) - begin, 9));
    if (theirs == ours)
      return;
  }
  throw InputError("Additional shared libraries: '" + name +
                   "' was built for another version of softgrain (its interface: " + theirs +
                   ", this program's: " + ours + "): build it anew with the headers of this one");
}
} // namespace softgrain
