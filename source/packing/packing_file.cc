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
                  of_balls = "x_m,y_m,z_m,radius_m", with_material = ",material";

/// Heading of a table of balls, in the plane disks.
template <int dim>
const std::string &plain_heading()
{
  return dim == 2 ? of_disks : of_balls;
}

const std::vector<std::pair<std::string, GrainForm2D::Kind>> kinds = {
    {"disk", GrainForm2D::Kind::disk},
    {"ellipse", GrainForm2D::Kind::ellipse},
    {"polygon", GrainForm2D::Kind::polygon}};

/// One line of a table.
template <int dim>
struct Entry
{
  typename Packing<dim>::Ball ball;
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

bool read_form(const std::vector<std::string> &cells, Entry<2> &entry)
{
  const auto kind =
      std::find_if(kinds.begin(), kinds.end(), [&](const auto &known) { return known.first == cells[2]; });
  double corners = 0.;
  if (kind == kinds.end() || !read_number(cells[3], entry.ball.radius) ||
      !read_number(cells[4], entry.form.short_radius) || !read_number(cells[5], corners) ||
      !read_number(cells[6], entry.form.angle))
    return false;
  entry.form.kind = kind->second;
  entry.form.corners = static_cast<unsigned int>(std::clamp(corners, 0., 1e4));
  const bool polygon = entry.form.kind == GrainForm2D::Kind::polygon;
  return entry.form.corners == corners && (polygon ? corners >= 3. : corners == 0.) &&
         entry.form.short_radius > 0. && entry.form.short_radius <= entry.ball.radius &&
         (entry.form.kind != GrainForm2D::Kind::disk || entry.form.short_radius == entry.ball.radius);
}

/// @return whether the line is a grain
template <int dim>
bool read_entry(const std::string &line, const bool grains, const bool materials, Entry<dim> &entry)
{
  const std::vector<std::string> cells = cells_of(line);
  const std::size_t n = (grains ? 7 : dim + 1) + (materials ? 1 : 0);
  if (cells.size() != n)
    return false;
  for (unsigned int d = 0; d < dim; ++d)
    if (!read_number(cells[d], entry.ball.center[d]))
      return false;
  bool is_grain = false;
  if constexpr (dim == 2)
    is_grain = grains ? read_form(cells, entry) : read_number(cells[dim], entry.ball.radius);
  else
    is_grain = read_number(cells[dim], entry.ball.radius);
  if (materials)
    entry.material = cells.back();
  return is_grain && entry.ball.radius > 0. && (!materials || !entry.material.empty());
}

/// What a table must be like.
template <int dim>
std::string form_of_table(const bool grains)
{
  if (grains)
    return "a line is x, y, one of disk, ellipse, polygon, the semi-axes a >= b > 0 (equal for a disk), the "
           "corners of a polygon (3 or more, else 0), an angle, and with the longer heading a name";
  return dim == 2 ? "the first line must be " + of_disks + " or " + of_grains + ", or one of these with " +
                        with_material +
                        ", the others three finite numbers, the last above 0, and with the longer one a name"
                  : "the first line must be " + of_balls + " or " + of_balls + with_material +
                        ", the others four finite numbers, the last above 0, and with the longer one a name";
}
} // namespace

template <int dim>
Packing<dim> read_packing(const std::string &file)
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
  const std::string plain = plain_heading<dim>();
  const bool grains = dim == 2 && (line == of_grains || line == of_grains + with_material);
  const bool materials = line == plain + with_material || (grains && line != of_grains);
  const auto complain = [&](const std::size_t number)
  {
    throw InputError("'Packing/File': line " + std::to_string(number) + " of '" + file +
                     "' is not allowed: " + form_of_table<dim>(grains));
  };
  if (!materials && !grains && line != plain)
    complain(1);
  Packing<dim> packing;
  packing.file = file;
  for (std::size_t number = 2; next_line(line); ++number)
  {
    Entry<dim> entry;
    if (!read_entry(line, grains, materials, entry))
      complain(number);
    packing.balls.push_back(entry.ball);
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
template <int dim>
std::string text_of(const Packing<dim> &packing)
{
  std::ostringstream out;
  const bool materials = !packing.materials.empty(), grains = !packing.forms.empty();
  out << (grains ? of_grains : plain_heading<dim>()) << (materials ? with_material : "") << '\n'
      << std::setprecision(17);
  for (std::size_t i = 0; i < packing.balls.size(); ++i)
  {
    const typename Packing<dim>::Ball &ball = packing.balls[i];
    for (unsigned int d = 0; d < dim; ++d)
      out << ball.center[d] << ',';
    if (grains)
      for (const auto &[name, kind] : kinds)
        out << (kind == packing.forms[i].kind ? name + "," : "");
    out << ball.radius;
    if (grains)
      out << ','
          << (packing.forms[i].kind == GrainForm2D::Kind::disk ? ball.radius : packing.forms[i].short_radius)
          << ',' << packing.forms[i].corners << ',' << packing.forms[i].angle;
    out << (materials ? "," + packing.materials[i] : "") << '\n';
  }
  return out.str();
}
} // namespace

template <int dim>
void write_packing(const std::string &file, const Packing<dim> &packing)
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

template <int dim>
bool holds_packing(const std::string &file, const Packing<dim> &packing)
{
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return in && text.str() == text_of(packing);
}

template Packing<2> read_packing<2>(const std::string &);
template Packing<3> read_packing<3>(const std::string &);
template void write_packing<2>(const std::string &, const Packing<2> &);
template void write_packing<3>(const std::string &, const Packing<3> &);
template bool holds_packing<2>(const std::string &, const Packing<2> &);
template bool holds_packing<3>(const std::string &, const Packing<3> &);
} // namespace softgrain
