// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/star_solid.h>
#include <softgrain/geometry/stl_file.h>
#include <softgrain/geometry/turned_axes.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace softgrain
{
namespace
{
using Place = dealii::Point<3>;
using Vector = dealii::Tensor<1, 3>;

constexpr unsigned int least_degree = 2, most_degree = 24;
/// Times 1/(degree + 1)^2: an edge that is cut off sharply makes waves beside it.
constexpr double damping = 1.5;
constexpr double apart = 0.08;       ///< directions that are looked at first [rad]
constexpr double beyond_seen = 1.05; ///< steepest slope between them, over the steepest that is seen
constexpr unsigned int most_moves = 50, most_sweeps = 10;
constexpr double rounding = 1e-13;

std::string in_words(const Place &x)
{
  std::ostringstream text;
  text << '(' << x << ") m";
  return text.str();
}

/// Every side of a triangle belongs to one other, which runs the other way.
void check_closed(const TriangulatedSurface &surface)
{
  std::map<std::array<unsigned int, 2>, int> sides;
  for (const auto &t : surface.triangles)
    for (unsigned int k = 0; k < 3; ++k)
      ++sides[{{t[k], t[(k + 1) % 3]}}];
  for (const auto &[side, times] : sides)
    if (const auto other = sides.find({{side[1], side[0]}}); times != 1 || other == sides.end())
      throw InputError("its triangles are not the closed surface of one body: see the side from " +
                       in_words(surface.vertices[side[0]]) + " to " + in_words(surface.vertices[side[1]]));
}

/// Volume and centroid.
std::pair<double, Place> volume_and_centroid(const TriangulatedSurface &surface)
{
  const Place &origin = surface.vertices[surface.triangles[0][0]];
  double volume = 0.;
  Vector moment;
  for (const auto &t : surface.triangles)
  {
    const Vector a = surface.vertices[t[0]] - origin, b = surface.vertices[t[1]] - origin,
                 c = surface.vertices[t[2]] - origin;
    const double part = a * dealii::cross_product_3d(b, c) / 6.;
    volume += part;
    moment += part / 4. * (a + b + c);
  }
  return {volume, origin + moment / volume};
}

/// How far the triangles are from the origin in a direction, from where all of them are seen.
double distance_of_triangles(const TriangulatedSurface &surface, const Vector &unit)
{
  double best = -std::numeric_limits<double>::max(), distance = 0.;
  for (const auto &t : surface.triangles)
  {
    const Vector a(surface.vertices[t[0]]), b(surface.vertices[t[1]]), c(surface.vertices[t[2]]);
    const double of_a = unit * dealii::cross_product_3d(b, c), of_b = unit * dealii::cross_product_3d(c, a),
                 of_c = unit * dealii::cross_product_3d(a, b), sum = of_a + of_b + of_c;
    // The triangle is met where all three are positive; rounding may say so of none.
    if (const double inside = std::min({of_a, of_b, of_c}) / std::abs(sum); sum > 0. && inside > best)
    {
      best = inside;
      distance = a * dealii::cross_product_3d(b, c) / sum;
    }
    if (best >= 0.)
      break;
  }
  return distance;
}
} // namespace

StarSolid::StarSolid(const Place &center,
                     TriangulatedSurface triangles,
                     const unsigned int degree,
                     const Vector &rotation)
    : center(center), rotation(rotation)
{
  fit(std::move(triangles), degree);
}

void StarSolid::fit(TriangulatedSurface triangles, const unsigned int degree)
{
  check_closed(triangles);
  auto [volume, centroid] = volume_and_centroid(triangles);
  if (volume < 0.)
    for (auto &t : triangles.triangles)
      std::swap(t[1], t[2]);
  const dealii::Tensor<2, 3> turn = turned_axes(rotation);
  for (Place &x : triangles.vertices)
    x = Place(turn * (x - centroid));
  for (const auto &t : triangles.triangles)
  {
    const Vector a(triangles.vertices[t[0]]), b(triangles.vertices[t[1]]), c(triangles.vertices[t[2]]);
    if (!(a * dealii::cross_product_3d(b, c) > 0.))
      throw InputError("the surface is not all seen from its centroid " + in_words(centroid) +
                       ", see the triangle at " + in_words(centroid + transpose(turn) * a) +
                       ": only bodies without such folds are there");
  }
  told_volume = std::abs(volume);
  distance = SphericalHarmonics(
      degree, [&](const Vector &unit) { return distance_of_triangles(triangles, unit); },
      damping / ((degree + 1.) * (degree + 1.)));
  const auto cube = [](const double r) { return r * r * r / 3.; };
  distance.scale(std::cbrt(told_volume / distance.integral(cube, 3)));
  for (const Place &unit : Sphere(Place(), 1.).surface(apart).vertices)
  {
    const double r = distance.value(Vector(unit));
    if (!(r > 0.))
      throw InputError("the surface comes too near to its centroid for this 'Degree'");
    farthest = std::max(farthest, r);
    seen.push_back(center + r * Vector(unit));
    steepest = std::max(steepest, beyond_seen * gauge(seen.back()).gradient.norm());
  }
}

void StarSolid::declare_parameters(dealii::ParameterHandler &prm) const
{
  using namespace dealii::Patterns;
  declare_rotation(prm);
  prm.declare_entry("File", "", Anything(),
                    "STL file with the closed surface of a body, all of which is seen from its centroid.");
  prm.declare_entry("Unit", "1", Double(0), "Length of the unit of the STL file. Units: m.");
  prm.declare_entry("Degree", "12", Integer(least_degree, most_degree),
                    "Degree of the spherical harmonics that the surface of an STL file is made smooth with: "
                    "edges are round by about the radius of the body over it.");
}

void StarSolid::parse_parameters(const dealii::ParameterHandler &prm, const Place &body_center)
{
  center = body_center;
  rotation = rotation_of(prm);
  try
  {
    if (prm.get("File").empty())
      throw InputError("with 'Shape' = 'stl' it must name a file");
    fit(read_stl(prm.get("File"), prm.get_double("Unit")), prm.get_integer("Degree"));
  }
  catch (const InputError &error)
  {
    trouble = error.what();
    *this = of_no_size(center, trouble);
  }
}

/// In place of a body that cannot be made: check() refuses it.
StarSolid StarSolid::of_no_size(const Place &center, const std::string &trouble)
{
  constexpr double radius = 1e-12;
  StarSolid nothing;
  nothing.center = center;
  nothing.trouble = trouble;
  nothing.distance = SphericalHarmonics(
      0, [](const Vector &) { return radius; }, 0.);
  nothing.farthest = radius;
  nothing.steepest = 1. / radius;
  nothing.seen = {center + Vector({radius, 0., 0.})};
  return nothing;
}

void StarSolid::check(const std::string &body) const
{
  if (!trouble.empty())
    throw InputError("'" + body + "/File': " + trouble);
}

Gauge StarSolid::gauge(const Place &p) const
{
  const double length = (p - center).norm();
  const Vector unit = (p - center) / length;
  const auto [r, slope, bend] = distance.at(unit);
  Gauge result;
  result.value = length / r;
  result.gradient = unit / r - slope / (r * r);
  for (unsigned int d = 0; d < 3; ++d)
    for (unsigned int e = 0; e <= d; ++e)
      result.hessian[d][e] = (((d == e ? 1. : 0.) - unit[d] * unit[e]) / r -
                              (unit[d] * slope[e] + slope[d] * unit[e] + bend[d][e]) / (r * r) +
                              2. * slope[d] * slope[e] / (r * r * r)) /
                             length;
  return result;
}

double StarSolid::depth(const Place &p) const
{
  const double length = (p - center).norm();
  return length > 0. ? (1. - length / distance.value((p - center) / length)) / steepest : 1. / steepest;
}

SurfacePlace<3> StarSolid::place(const Place &x) const
{
  return place_on_ray(center, x, gauge(x));
}

/// From the farthest place that was seen by Newton's method along the surface, where that leads on.
double StarSolid::reach(const Vector &normal) const
{
  const Place best = *std::max_element(
      seen.begin(), seen.end(), [&](const Place &a, const Place &b) { return a * normal < b * normal; });
  SurfacePlace<3> here = place(best);
  for (unsigned int move = 0; move < most_moves; ++move)
  {
    const dealii::Tensor<1, 2> slope({here.tangent[0] * normal, here.tangent[1] * normal});
    dealii::Tensor<1, 2> way = farthest * slope;
    if (determinant(here.bend) > 0. && trace(here.bend) > 0.)
      way = invert(here.bend) * slope / (here.normal * normal);
    bool higher = false;
    for (double share = 1.; share > 1e-6 && !higher; share *= 0.5)
    {
      const SurfacePlace<3> there =
          place(here.position + share * (way[0] * here.tangent[0] + way[1] * here.tangent[1]));
      higher = there.position * normal > here.position * normal;
      if (higher)
        here = there;
    }
    if (!higher || slope.norm() < rounding)
      break;
  }
  return (here.position - center) * normal;
}

std::pair<double, double> StarSolid::distances_from_plane(const Place &point, const Vector &normal) const
{
  const double middle = (center - point) * normal;
  return {middle - reach(-normal), middle + reach(normal)};
}

TriangulatedSurface StarSolid::surface(const double spacing) const
{
  return finely(spacing,
                [&](const double finer)
                {
                  TriangulatedSurface result = Sphere(Place(), 1.).surface(finer / farthest);
                  for (Place &x : result.vertices)
                    x = center + distance.value(Vector(x)) * Vector(x);
                  return result;
                });
}

StarSolid::Place
StarSolid::deepest_beside(Place from, const Place &lower, const Place &upper, const double sign) const
{
  constexpr unsigned int halvings = 12;
  const double least_move = lower.distance(upper) / (1 << halvings);
  for (unsigned int sweep = 0; sweep < most_sweeps && !(sign * depth(from) > 0.); ++sweep)
  {
    const Place before = from;
    for (unsigned int d = 0; d < 3; ++d)
    {
      double low = lower[d], high = upper[d];
      for (unsigned int halving = 0; halving < halvings; ++halving)
      {
        from[d] = 0.5 * (low + high);
        (sign * gauge(from).gradient[d] > 0. ? high : low) = from[d];
      }
    }
    if (from.distance(before) <= least_move)
      break;
  }
  return from;
}

/// Between a place inside and one outside: one of the corners and the middle, or what is deepest beside the
/// best of these.
std::optional<StarSolid::Place> StarSolid::surface_in_box(const Place &lower, const Place &upper) const
{
  const Place middle = lower + 0.5 * (upper - lower);
  if (std::abs(depth(middle)) > 0.5 * lower.distance(upper))
    return std::nullopt;
  Place inside = middle, outside = middle;
  double deepest = depth(middle), highest = deepest;
  for (unsigned int c = 0; c < 8; ++c)
  {
    const Place corner(c & 1 ? upper[0] : lower[0], c & 2 ? upper[1] : lower[1], c & 4 ? upper[2] : lower[2]);
    const double here = depth(corner);
    if (here > deepest)
    {
      deepest = here;
      inside = corner;
    }
    if (here < highest)
    {
      highest = here;
      outside = corner;
    }
  }
  inside = deepest_beside(inside, lower, upper, 1.);
  outside = deepest_beside(outside, lower, upper, -1.);
  if (!(depth(inside) > 0. && depth(outside) < 0.))
    return std::nullopt;
  for (unsigned int halving = 0; halving < 50; ++halving)
  {
    const Place between = inside + 0.5 * (outside - inside);
    (depth(between) > 0. ? inside : outside) = between;
  }
  return inside;
}

std::vector<double> StarSolid::numbers() const
{
  std::vector<double> all = {told_volume, farthest, steepest};
  for (const Vector &of_three : {Vector(center), rotation})
    for (unsigned int d = 0; d < 3; ++d)
      all.push_back(of_three[d]);
  for (const Place &x : seen)
    all.push_back(x.distance(center));
  return all;
}

namespace
{
[[maybe_unused]] const bool registered = Registry<Shape<3>>::instance().add(
    "stl",
    "File, Unit, Degree and Rotation: a closed surface of triangles, made smooth",
    [] { return std::make_unique<StarSolid>(); });
} // namespace
} // namespace softgrain
