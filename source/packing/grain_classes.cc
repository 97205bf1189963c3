// SPDX-License-Identifier: LGPL-2.1-or-later
// Classes of grains: how many of each there are, and how a user writes them.
#include <softgrain/base/exceptions.h>
#include <softgrain/packing/packing.h>
#include <softgrain/parameters/parameter_file.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <sstream>

namespace softgrain
{
namespace
{
const std::string of_text = "'Packing/Classes'", of_table = "'Packing/Class table'";
const std::string columns = "share,smallest_m,largest_m",
                  form = "\"share: diameter [to diameter][, material][, shape]; ...\"";

std::optional<GrainForm2D::Kind> kind_of(const std::string &word)
{
  using Kind = GrainForm2D::Kind;
  return word == "disk"      ? std::optional(Kind::disk)
         : word == "ellipse" ? std::optional(Kind::ellipse)
         : word == "polygon" ? std::optional(Kind::polygon)
                             : std::nullopt;
}

/// A number that a share or a diameter can be. @param where begins the message
double positive(const std::string &word, const std::string &where)
{
  std::istringstream in(word);
  double number = 0.;
  if (!(in >> number) || !in.eof() || !std::isfinite(number) || !(number > 0.))
    throw InputError(where + ": '" + word + "' is not allowed: it must be a number above 0");
  return number;
}

/// What follows the sizes of a class: a shape, or the name of a material.
void take_word(GrainClass2D &one, const std::string &word, const std::string &where)
{
  const std::optional<GrainForm2D::Kind> kind = kind_of(word);
  if (word.empty() || (kind ? one.kind.has_value() : !one.material.empty()))
    throw InputError(where + ": '" + word +
                     "' is not allowed: a class has at most one material and one of disk, ellipse, polygon");
  if (kind)
    one.kind = kind;
  else
    one.material = word;
}

/// @throw InputError when classes do not go together
std::vector<GrainClass2D> checked(std::vector<GrainClass2D> classes, const std::string &where)
{
  const bool named = !classes.empty() && !classes.front().material.empty();
  for (const GrainClass2D &one : classes)
  {
    if (one.smallest > one.largest)
      throw InputError(where + ": the second diameter of a class must be at least the first");
    if (one.material.empty() == named)
      throw InputError(where + ": either all classes name a material, or none does");
  }
  return classes;
}
} // namespace

double GrainClass2D::mean_area() const
{
  return dealii::numbers::PI / 12. * (smallest * smallest + smallest * largest + largest * largest);
}

std::vector<GrainClass2D> parse_classes(const std::string &text)
{
  std::vector<GrainClass2D> classes;
  for (const std::string &part : dealii::Utilities::split_string_list(text, ';'))
  {
    const auto colon = part.find(':');
    if (colon == std::string::npos)
      throw InputError(of_text + ": '" + part + "' is not allowed: it must be " + form);
    GrainClass2D one;
    one.share = positive(dealii::Utilities::trim(part.substr(0, colon)), of_text);
    const std::vector<std::string> words = dealii::Utilities::split_string_list(part.substr(colon + 1), ',');
    if (words.empty())
      throw InputError(of_text + ": '" + part + "' is not allowed: it must be " + form);
    const auto to = words[0].find(" to ");
    one.smallest = positive(dealii::Utilities::trim(words[0].substr(0, to)), of_text);
    one.largest = to == std::string::npos
                      ? one.smallest
                      : positive(dealii::Utilities::trim(words[0].substr(to + 4)), of_text);
    for (std::size_t w = 1; w < words.size(); ++w)
      take_word(one, words[w], of_text);
    classes.push_back(one);
  }
  return checked(classes, of_text);
}

std::vector<GrainClass2D> read_classes(const std::string &file)
{
  if (!std::filesystem::is_regular_file(file))
    throw InputError(of_table + ": there is no file '" + file + "' that can be read");
  std::istringstream lines(read_text_file(file));
  std::vector<GrainClass2D> classes;
  std::size_t width = 0, number = 0;
  for (std::string line; std::getline(lines, line);)
  {
    if (!line.empty() && line.back() == '\r')
      line.pop_back();
    const std::string where = of_table + ": line " + std::to_string(++number) + " of '" + file + "'";
    if (number == 1)
    {
      if (line != columns && line != columns + ",material" && line != columns + ",shape" &&
          line != columns + ",material,shape")
        throw InputError(where + " is not allowed: the first line must be " + columns +
                         ", and may go on with ,material and ,shape");
      width = std::count(line.begin(), line.end(), ',') + 1;
      continue;
    }
    const std::vector<std::string> cells = dealii::Utilities::split_string_list(line, ',');
    if (cells.size() != width)
      throw InputError(where + " is not allowed: it must have " + std::to_string(width) + " values");
    GrainClass2D one;
    one.share = positive(cells[0], where);
    one.smallest = positive(cells[1], where);
    one.largest = positive(cells[2], where);
    for (std::size_t w = 3; w < cells.size(); ++w)
      take_word(one, cells[w], where);
    classes.push_back(one);
  }
  if (classes.empty())
    throw InputError(of_table + ": there are no classes in '" + file + "'");
  return checked(classes, of_table + ": '" + file + "'");
}

bool PackingRequest2D::only_disks() const
{
  const auto disk = [this](const GrainClass2D &one)
  { return one.kind ? *one.kind == GrainForm2D::Kind::disk : mix.only_disks(); };
  return classes.empty() ? mix.only_disks() : std::all_of(classes.begin(), classes.end(), disk);
}

std::vector<unsigned int> PackingRequest2D::numbers() const
{
  if (classes.empty())
    return {};
  std::vector<double> wanted;
  for (const GrainClass2D &one : classes)
    wanted.push_back(one.share / (shares_of_area ? one.mean_area() : 1.));
  const double sum = std::accumulate(wanted.begin(), wanted.end(), 0.);
  std::vector<unsigned int> result;
  unsigned int left = number;
  for (double &one : wanted)
  {
    one *= number / sum;
    result.push_back(static_cast<unsigned int>(std::floor(one * (1. + 1e-12))));
    left -= std::min(left, result.back());
  }
  // Those that lose most by rounding get the rest, the first of equals first.
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](const std::size_t a, const std::size_t b)
                   { return wanted[a] - result[a] > wanted[b] - result[b] + 1e-9; });
  for (std::size_t i = 0; i < left; ++i)
    ++result[order[i]];
  for (std::size_t c = 0; c < result.size(); ++c)
    if (result[c] == 0)
      throw InputError("'Packing/Number' = '" + std::to_string(number) + "' is too small: class " +
                       std::to_string(c + 1) + " would have no grain");
  return result;
}
} // namespace softgrain
