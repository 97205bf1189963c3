// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/packing/packing.h>
#include <softgrain/parameters/parameter_file.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace softgrain
{
namespace
{
const std::string heading = "x_m,y_m,radius_m";
}

Packing read_packing(const std::string &file)
{
  if (!std::filesystem::is_regular_file(file))
    throw InputError("'Packing/File': there is no file '" + file + "' that can be read");
  std::istringstream in;
  try
  {
    in.str(read_text_file(file));
  }
  catch (const InputError &error)
  {
    throw InputError(std::string("'Packing/File': ") + error.what());
  }
  const auto next_line = [&in](std::string &line)
  {
    if (!std::getline(in, line))
      return false;
    if (!line.empty() && line.back() == '\r') // lines of Windows end with it
      line.pop_back();
    return true;
  };
  const auto complain = [&](const std::size_t number)
  {
    throw InputError("'Packing/File': line " + std::to_string(number) + " of '" + file +
                     "' is not allowed: the first line must be " + heading +
                     ", the others three finite numbers, the last above 0");
  };
  std::string line;
  next_line(line);
  if (line != heading)
    complain(1);
  Packing packing;
  for (std::size_t number = 2; next_line(line); ++number)
  {
    std::istringstream fields(line);
    Packing::Disk disk;
    char first = 0, second = 0;
    if (!(fields >> disk.center[0] >> first >> disk.center[1] >> second >> disk.radius) || first != ',' ||
        second != ',' || !(fields >> std::ws).eof() || !std::isfinite(disk.center.norm()) ||
        !std::isfinite(disk.radius) || !(disk.radius > 0.))
      complain(number);
    packing.disks.push_back(disk);
  }
  if (packing.disks.empty())
    throw InputError("'Packing/File': there are no disks in '" + file + "'");
  return packing;
}

void write_packing(const std::string &file, const Packing &packing)
{
  const std::string unfinished = file + ".part";
  std::ofstream out(unfinished);
  out << heading << '\n' << std::setprecision(17);
  for (const Packing::Disk &disk : packing.disks)
    out << disk.center[0] << ',' << disk.center[1] << ',' << disk.radius << '\n';
  out.close();
  std::error_code error;
  if (out)
    std::filesystem::rename(unfinished, file, error);
  if (!out || error)
    throw InputError("the packing cannot be written to '" + file + "'");
}
} // namespace softgrain
