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
const std::string heading_with_material = heading + ",material";

/// A disk of a line, and the name of its material when it has one. @return whether the line is a disk.
bool read_disk(const std::string &line, const bool with_material, Packing::Disk &disk, std::string &material)
{
  std::istringstream fields(line);
  char first = 0, second = 0, third = ',';
  fields >> disk.center[0] >> first >> disk.center[1] >> second >> disk.radius;
  material.clear();
  if (with_material && fields >> third >> std::ws)
    std::getline(fields, material);
  material.erase(material.find_last_not_of(" \t") + 1);
  const bool whole = with_material ? !material.empty() : fields && (fields >> std::ws).eof();
  return whole && first == ',' && second == ',' && third == ',' && std::isfinite(disk.center.norm()) &&
         std::isfinite(disk.radius) && disk.radius > 0.;
}
} // namespace

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
                     "' is not allowed: the first line must be " + heading + " or " + heading_with_material +
                     ", the others three finite numbers, the last above 0, and with the longer one a name");
  };
  std::string line;
  next_line(line);
  const bool with_material = line == heading_with_material;
  if (line != heading && !with_material)
    complain(1);
  Packing packing;
  packing.file = file;
  for (std::size_t number = 2; next_line(line); ++number)
  {
    Packing::Disk disk;
    std::string material;
    if (!read_disk(line, with_material, disk, material))
      complain(number);
    packing.disks.push_back(disk);
    if (with_material)
      packing.materials.push_back(material);
  }
  if (packing.disks.empty())
    throw InputError("'Packing/File': there are no disks in '" + file + "'");
  return packing;
}

void write_packing(const std::string &file, const Packing &packing)
{
  const std::string unfinished = file + ".part";
  std::ofstream out(unfinished);
  const bool with_material = !packing.materials.empty();
  out << (with_material ? heading_with_material : heading) << '\n' << std::setprecision(17);
  for (std::size_t i = 0; i < packing.disks.size(); ++i)
  {
    const Packing::Disk &disk = packing.disks[i];
    out << disk.center[0] << ',' << disk.center[1] << ',' << disk.radius
        << (with_material ? "," + packing.materials[i] : "") << '\n';
  }
  out.close();
  std::error_code error;
  if (out)
    std::filesystem::rename(unfinished, file, error);
  if (!out || error)
    throw InputError("the packing cannot be written to '" + file + "'");
}
} // namespace softgrain
