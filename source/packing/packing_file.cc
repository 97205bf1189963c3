// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/packing/packing.h>
#include <softgrain/parameters/parameter_file.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <utility>
#include <vector>

namespace softgrain
{
namespace
{
const std::string of_disks = "x_m,y_m,radius_m", of_grains = "x_m,y_m,shape,a_m,b_m,corners,angle_deg",
                  with_material = ",material";

const std::vector<std::pair<std::string, GrainForm2D::Kind>> kinds = {
    {"disk", GrainForm2D::Kind::disk},
    {"ellipse", GrainForm2D::Kind::ellipse},
    {"polygon", GrainForm2D::Kind::polygon}};

/// One line of a table.
struct Entry
{
  Packing<2>::Ball disk;
  GrainForm2D form;
  std::string material;
};

/// The cells of a line without the blanks around them.
std::vector<std::string> cells_of(const std::string &line)
{
  std::vector<std::string> cells;
  std::istringstream fields(line);
  for (std::string cell; std::getline(fields, cell, ',');)
  {
    cell.erase(cell.find_last_not_of(" \t") + 1);
    cell.erase(0, std::min(cell.find_first_not_of(" \t"), cell.size()));
    cells.push_back(cell);
  }
  if (!line.empty() && line.back() == ',')
    cells.emplace_back();
  return cells;
}

/// @return whether the text is a number and nothing else, and finite
bool read_number(const std::string &text, double &number)
{
  std::istringstream in(text);
  return !text.empty() && in >> number && in.eof() && std::isfinite(number);
}

bool read_form(const std::vector<std::string> &cells, Entry &entry)
{
  const auto kind =
      std::find_if(kinds.begin(), kinds.end(), [&](const auto &known) { return known.first == cells[2]; });
  double corners = 0.;
  if (kind == kinds.end() || !read_number(cells[3], entry.disk.radius) ||
      !read_number(cells[4], entry.form.short_radius) || !read_number(cells[5], corners) ||
      !read_number(cells[6], entry.form.angle))
    return false;
  entry.form.kind = kind->second;
  entry.form.corners = static_cast<unsigned int>(std::clamp(corners, 0., 1e4));
  const bool polygon = entry.form.kind == GrainForm2D::Kind::polygon;
  return entry.form.corners == corners && (polygon ? corners >= 3. : corners == 0.) &&
         entry.form.short_radius > 0. && entry.form.short_radius <= entry.disk.radius &&
         (entry.form.kind != GrainForm2D::Kind::disk || entry.form.short_radius == entry.disk.radius);
}

/// @return whether the line is a grain
bool read_entry(const std::string &line, const bool grains, const bool materials, Entry &entry)
{
  const std::vector<std::string> cells = cells_of(line);
  const std::size_t n = (grains ? 7 : 3) + (materials ? 1 : 0);
  if (cells.size() != n || !read_number(cells[0], entry.disk.center[0]) ||
      !read_number(cells[1], entry.disk.center[1]))
    return false;
  if (grains ? !read_form(cells, entry) : !read_number(cells[2], entry.disk.radius))
    return false;
  if (materials)
    entry.material = cells.back();
  return entry.disk.radius > 0. && (!materials || !entry.material.empty());
}
} // namespace

Packing<2> read_packing(const std::string &file)
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
  std::string line;
  next_line(line);
  const bool materials = line == of_disks + with_material || line == of_grains + with_material;
  const bool grains = line == of_grains || line == of_grains + with_material;
  const auto complain = [&](const std::size_t number)
  {
    throw InputError(
        "'Packing/File': line " + std::to_string(number) + " of '" + file + "' is not allowed: " +
        (grains ? "a line is x, y, one of disk, ellipse, polygon, the semi-axes a >= b > 0 (equal for a "
                  "disk), the "
                  "corners of a polygon (3 or more, else 0), an angle, and with the longer heading a name"
                : "the first line must be " + of_disks + " or " + of_grains + ", or one of these with " +
                      with_material +
                      ", the others three finite numbers, the last above 0, and with the longer one a name"));
  };
  if (!materials && !grains && line != of_disks)
    complain(1);
  Packing<2> packing;
  packing.file = file;
  for (std::size_t number = 2; next_line(line); ++number)
  {
    Entry entry;
    if (!read_entry(line, grains, materials, entry))
      complain(number);
    packing.balls.push_back(entry.disk);
    if (grains)
      packing.forms.push_back(entry.form);
    if (materials)
      packing.materials.push_back(entry.material);
  }
  if (packing.balls.empty())
    throw InputError("'Packing/File': there are no grains in '" + file + "'");
  return packing;
}

namespace
{
std::string text_of(const Packing<2> &packing)
{
  std::ostringstream out;
  const bool materials = !packing.materials.empty(), grains = !packing.forms.empty();
  out << (grains ? of_grains : of_disks) << (materials ? with_material : "") << '\n' << std::setprecision(17);
  for (std::size_t i = 0; i < packing.balls.size(); ++i)
  {
    const Packing<2>::Ball &disk = packing.balls[i];
    out << disk.center[0] << ',' << disk.center[1] << ',';
    if (grains)
      for (const auto &[name, kind] : kinds)
        out << (kind == packing.forms[i].kind ? name + "," : "");
    out << disk.radius;
    if (grains)
      out << ','
          << (packing.forms[i].kind == GrainForm2D::Kind::disk ? disk.radius : packing.forms[i].short_radius)
          << ',' << packing.forms[i].corners << ',' << packing.forms[i].angle;
    out << (materials ? "," + packing.materials[i] : "") << '\n';
  }
  return out.str();
}
} // namespace

void write_packing(const std::string &file, const Packing<2> &packing)
{
  const std::string unfinished = file + ".part";
  std::ofstream out(unfinished);
  out << text_of(packing);
  out.close();
  std::error_code error, ignored;
  if (out)
    std::filesystem::rename(unfinished, file, error);
  if (!out || error)
    std::filesystem::remove(unfinished, ignored);
  if (!out || error)
    throw InputError("the packing cannot be written to '" + file + "'");
}

bool holds_packing(const std::string &file, const Packing<2> &packing)
{
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return in && text.str() == text_of(packing);
}
} // namespace softgrain
