// SPDX-License-Identifier: LGPL-2.1-or-later
// Files that have their names at once and are brought to the disk later: all are whole, one that is removed
// meanwhile does no harm, and a refusal is told again each time.
#include <softgrain/base/exceptions.h>
#include <softgrain/output/atomic_file.h>
#include <softgrain/output/late_files.h>

#include <filesystem>
#include <fstream>
#include <iostream>

using namespace softgrain;

namespace
{
std::string path_of(const unsigned int n)
{
  return "late/" + std::to_string(n % 3) + "/" + std::to_string(n);
}

std::string content_of(const std::string &path)
{
  std::ifstream file(path);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

void bring(LateFiles &late)
{
  try
  {
    late.bring_to_disk();
    std::cout << "all are on the disk\n";
  }
  catch (const ComputationError &error)
  {
    std::cout << error.what() << '\n';
  }
}
} // namespace

int main()
{
  std::filesystem::remove_all("late");
  LateFiles late;
  bring(late);
  constexpr unsigned int n_files = 50;
  for (unsigned int n = 0; n < n_files; ++n)
    write_file_atomically(path_of(n), "content of " + std::to_string(n), late);
  unsigned int whole = 0;
  for (unsigned int n = 0; n < n_files; ++n)
    whole += content_of(path_of(n)) == "content of " + std::to_string(n) &&
             !std::filesystem::exists(path_of(n) + ".part");
  std::cout << whole << " of " << n_files << " have their names before they are on the disk\n";
  std::filesystem::remove(path_of(7));
  bring(late);
  bring(late);

  // Something that is no folder cannot be brought to the disk as one. That stays said, though a next try
  // would find all well.
  late.add("late/0/0/nothing");
  bring(late);
  std::filesystem::remove(path_of(0));
  bring(late);
  return 0;
}
