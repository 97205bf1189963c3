// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the surface of a deformed body meets a ray: in the plane and in space, on a round body and, in the
// plane, on the outline of an ellipse. The height is that of the exact surface, and its first and second
// derivatives are those of differences: errors relative to the derivative fall to rounding. A rigid motion
// along the ray moves the height by as much, one across by the slope. Last, a curve through markers: its
// distance from the ellipse and the error of its curvature fall with the fourth and second power of their
// distance; sides of a square stay straight; a ray that passes a corner is not met. Of a square that stands
// on a tip such a ray goes on around the corner, from either side, and meets the other side where it is: the
// error is rounding. It does not go on where the side beyond looks away, nor in a dent. Past the
// end of a side a ray meets the straight line on which the side would go on, with the same derivatives.
#include <softgrain/geometry/outline_surface.h>
#include <softgrain/mpm/contact/ray.h>

#include <cmath>
#include <iostream>
#include <random>

using namespace softgrain;
using namespace softgrain::mpm;

namespace
{
/// A disk or a ball.
template <int dim>
class Ball : public RestSurface<dim>
{
public:
  Ball(const dealii::Point<dim> &center, const double radius) : center(center), radius(radius) {}

  SurfacePlace<dim> at(const dealii::Tensor<1, dim> &arm) const
  {
    SurfacePlace<dim> place;
    place.normal = arm / arm.norm();
    place.position = center + radius * place.normal;
    unsigned int largest = 0;
    for (unsigned int d = 0; d < dim; ++d)
      if (std::abs(place.normal[d]) > std::abs(place.normal[largest]))
        largest = d;
    for (unsigned int k = 0; k < dim - 1; ++k)
    {
      dealii::Tensor<1, dim> t;
      t[(largest + 1 + k) % dim] = 1.;
      t -= (t * place.normal) * place.normal;
      for (unsigned int l = 0; l < k; ++l)
        t -= (t * place.tangent[l]) * place.tangent[l];
      place.tangent[k] = t / t.norm();
      place.bend[k][k] = 1. / radius;
    }
    return place;
  }

  SurfacePlace<dim> move(const SurfacePlace<dim> &place, const dealii::Tensor<1, dim - 1> &way) const override
  {
    dealii::Tensor<1, dim> arm = radius * place.normal;
    for (unsigned int k = 0; k < dim - 1; ++k)
      arm += way[k] * place.tangent[k];
    return at(arm);
  }

  const dealii::Point<dim> center;
  const double radius;
};

/// The field of a ball of radius 2.3 cells; at its rim nodes are extended.
template <int dim>
class Field
{
public:
  explicit Field(const std::string &shape_name)
      : lattice(dealii::Point<dim>(), all(8.), 1.), shape(create_shape_function(shape_name))
  {
    const double step = 1. / 3.;
    std::vector<dealii::Point<dim>> points, markers;
    const unsigned int n = 24;
    for (unsigned int k = 0; k < std::pow(n, dim); ++k)
    {
      dealii::Point<dim> x;
      for (unsigned int d = 0, rest = k; d < dim; ++d, rest /= n)
        x[d] = (rest % n + 0.5) * step;
      (x.distance(center()) < 2.3 ? points : markers).push_back(x);
    }
    // Where its surface may be, the field is known.
    markers.erase(std::remove_if(markers.begin(), markers.end(),
                                 [](const auto &x) { return x.distance(center()) > 2.8; }),
                  markers.end());
    std::stable_sort(points.begin(), points.end(),
                     [this](const auto &a, const auto &b)
                     { return lattice.cell_of(a) < lattice.cell_of(b); });
    const std::vector<double> volumes(points.size(), std::pow(step, dim)), extent(points.size(), 0.5 * step);
    field.build(lattice, *shape, {points, volumes, extent, markers}, 0.5);
  }

  static dealii::Point<dim> all(const double x)
  {
    dealii::Point<dim> p;
    for (unsigned int d = 0; d < dim; ++d)
      p[d] = x;
    return p;
  }
  static dealii::Point<dim> center()
  {
    dealii::Point<dim> p = all(4.);
    p[0] += 0.13;
    p[1] -= 0.09;
    return p;
  }

  /// Smooth changes of the nodes.
  Eigen::VectorXd changes(const unsigned int seed, const double size) const
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1., 1.);
    Eigen::VectorXd result(field.n_dofs());
    dealii::Tensor<2, dim> strain, wave;
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e < dim; ++e)
      {
        strain[d][e] = number(random);
        wave[d][e] = number(random);
      }
    for (unsigned int i = 0; i < field.n_independent(); ++i)
    {
      const auto arm = field.place(i) - center();
      for (unsigned int d = 0; d < dim; ++d)
        result[dim * i + d] = size * (strain[d] * arm + std::sin(wave[d] * arm));
    }
    return result;
  }

  Lattice<dim> lattice;
  std::unique_ptr<ShapeFunction> shape;
  BodyField<dim> field;
};

template <int dim>
Ray<dim> some_ray()
{
  Ray<dim> ray;
  for (unsigned int d = 0; d < dim; ++d)
    ray.direction[d] = d == 0 ? 1. : 0.2 * (d + 1.);
  ray.direction /= ray.direction.norm();
  const SurfacePlace<dim> frame = Ball<dim>(Field<dim>::center(), 1.).at(ray.direction);
  ray.across = frame.tangent;
  ray.origin = Field<dim>::center() + 2.5 * ray.direction;
  for (unsigned int k = 0; k < dim - 1; ++k)
    ray.offset[k] = 0.4 - 0.7 * k;
  return ray;
}

template <int dim>
double second(const RaySide<dim> &side, const Eigen::VectorXd &v, const Eigen::VectorXd &w)
{
  double sum = 0.;
  side.second_derivative(
      [&](const unsigned int i, const unsigned int j, const dealii::Tensor<2, dim> &block)
      { sum += PlaceFunctions<dim>::of_node(v, i) * (block * PlaceFunctions<dim>::of_node(w, j)); });
  return sum;
}

/// @param meets what the ray meets with given displacements of the nodes
template <int dim, class Meets>
void check_derivatives(const std::string &name,
                       const Field<dim> &body,
                       const Ray<dim> &ray,
                       const Meets &meets)
{
  const Eigen::VectorXd u = body.changes(1, 0.03);
  const RaySide<dim> side = meets(u);
  double first_error = 0., second_error = 0., asymmetry = 0.;
  for (unsigned int seed = 2; seed < 6; ++seed)
  {
    const Eigen::VectorXd v = body.changes(seed, 1.), w = body.changes(seed + 10, 1.);
    constexpr double little = 1e-4;
    const RaySide<dim> after = meets(u + little * v), before = meets(u - little * v);
    const double first = (after.height - before.height) / (2. * little);
    first_error = std::max(first_error, std::abs(side.change(v) / first - 1.));
    // Of the first derivative, so that differences of second order do not drown in rounding.
    const double by_differences = (after.change(w) - before.change(w)) / (2. * little);
    second_error = std::max(second_error, std::abs(second(side, v, w) / by_differences - 1.));
    asymmetry = std::max(asymmetry, std::abs(second(side, v, w) - second(side, w, v)));
  }
  Eigen::VectorXd along(u.size()), across(u.size());
  for (unsigned int i = 0; i < u.size(); ++i)
  {
    along[i] = ray.direction[i % dim];
    across[i] = ray.across[0][i % dim];
  }
  std::cout << name << ": met " << side.met << ", first derivative off by less than 1e-6 "
            << (first_error < 1e-6) << ", second by less than 1e-5 " << (second_error < 1e-5)
            << ", symmetric " << (asymmetry < 1e-12) << '\n'
            << name << ": moved along the ray " << side.change(along) << ", its own second derivative "
            << second(side, along, along) << ", across against the slope "
            << side.change(across) - side.normal * ray.across[0] << '\n';
  if (!(first_error < 1e-6 && second_error < 1e-5))
    std::cout << first_error << ' ' << second_error << '\n';
}

template <int dim>
void check(const std::string &name,
           const Field<dim> &body,
           const RestSurface<dim> &surface,
           const SurfacePlace<dim> &guess)
{
  const Ray<dim> ray = some_ray<dim>();
  const auto meets = [&](const Eigen::VectorXd &nodal)
  {
    RaySide<dim> side = meet(ray, surface, body.field, nodal, guess);
    if (side.met)
      side.find_functions(body.field);
    return side;
  };
  check_derivatives(name, body, ray, meets);
  const RaySide<dim> at_rest = meets(Eigen::VectorXd::Zero(body.field.n_dofs()));
  double off = 0.;
  for (unsigned int k = 0; k < dim - 1; ++k)
    off += ray.offset[k] * ray.offset[k];
  std::cout << name << ": height at rest right to a ten-millionth of a cell "
            << (std::abs(at_rest.height - (std::sqrt(2.3 * 2.3 - off) - 2.5)) < 1e-7) << '\n';
}

/// An ellipse or a circle through n vertices.
OutlineSurface ellipse(const dealii::Point<2> &center, const double a, const double b, const unsigned int n)
{
  std::vector<dealii::Point<2>> vertices;
  for (unsigned int i = 0; i < n; ++i)
    vertices.emplace_back(center[0] + a * std::cos(2. * M_PI * i / n),
                          center[1] + b * std::sin(2. * M_PI * i / n));
  return OutlineSurface(vertices, {0, n}, std::vector<char>(n, 0));
}

void check_curve()
{
  double position_before = 0., bend_before = 0.;
  for (const unsigned int n : {32, 64, 128})
  {
    const OutlineSurface curve = ellipse({0., 0.}, 2., 1., n);
    double position_error = 0., bend_error = 0.;
    for (unsigned int m = 0; m < n; ++m)
      for (const double share : {0.2, 0.5, 0.9})
      {
        const SurfacePlace<2> place = curve.at(m, share * curve.length(m));
        const double x = place.position[0] / 2., y = place.position[1], angle = std::atan2(y, x);
        position_error = std::max(position_error, std::abs(std::hypot(x, y) - 1.));
        const double exact =
            2. / std::pow(4. * std::pow(std::sin(angle), 2) + std::pow(std::cos(angle), 2), 1.5);
        bend_error = std::max(bend_error, std::abs(place.bend[0][0] - exact));
      }
    if (position_before > 0.)
      std::cout << "ellipse, twice the markers: place better by 2^"
                << std::log2(position_before / position_error) << ", curvature by 2^"
                << std::log2(bend_before / bend_error) << '\n';
    position_before = position_error;
    bend_before = bend_error;
  }
  const OutlineSurface square({{-2., -2.}, {0.5, -2.}, {2., -2.}, {2., 2.}, {-2., 2.}, {-2., 1.}}, {0, 6},
                              {1, 0, 1, 1, 1, 0});
  SurfacePlace<2> place = square.at(0, 0.);
  dealii::Tensor<1, 1> way;
  way[0] = 3.7;
  place = square.move(place, way);
  std::cout << "square: 3.7 from a corner at " << place.position << ", bend " << place.bend[0][0]
            << ", at a corner " << place.at_edge;
  place = square.move(place, way);
  std::cout << ", further on at " << place.position << ", at a corner " << place.at_edge << '\n';
}

/// Where a ray along x, at @p offset, goes on around the first corner. @param from_begin it comes
/// from the side that begins there, not from the one that ends
void go_around(const char *name,
               const Field<2> &disk,
               const std::vector<dealii::Point<2>> &corners,
               const double offset,
               const bool from_begin,
               const double exact)
{
  Ray<2> ray;
  ray.direction = dealii::Tensor<1, 2>({1., 0.});
  ray.across[0] = dealii::Tensor<1, 2>({0., 1.});
  ray.origin = Field<2>::center();
  ray.offset[0] = offset;
  std::vector<dealii::Point<2>> moved;
  for (const dealii::Point<2> &x : corners)
    moved.push_back(x + dealii::Tensor<1, 2>(Field<2>::center()));
  const unsigned int n = corners.size();
  const OutlineSurface surface(moved, {0, n}, std::vector<char>(n, 1));
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(disk.field.n_dofs());
  const SurfacePlace<2> guess = from_begin ? surface.at(0, 0.5) : surface.at(n - 1, 0.5);
  const RaySide<2> without = meet<2>(ray, surface, disk.field, still, guess);
  const RaySide<2> side = meet_around(ray, surface, disk.field, still, without.place);
  std::cout << name << ": without " << without.met << ", around the corner " << side.met << ", exact "
            << (side.met && std::abs(side.height - exact) < 1e-12) << '\n';
}

/// A corner between two sides that both face the ray, one whose other side looks away, and a dent.
void go_around_corners(const Field<2> &disk)
{
  const std::vector<dealii::Point<2>> tip{{1.5, 0.}, {0., 1.5}, {-1.5, 0.}, {0., -1.5}},
      square{{1.5, 1.5}, {-1.5, 1.5}, {-1.5, -1.5}, {1.5, -1.5}},
      dent{{0.5, 0.}, {1.5, 1.}, {-1.5, 1.}, {-1.5, -1.}, {1.5, -1.}};
  go_around("tip, from the side that ends", disk, tip, 0.2, false, 1.3);
  go_around("tip, from the side that begins", disk, tip, -0.2, true, 1.3);
  go_around("square, whose next side looks away", disk, square, 1.6, false, 0.);
  go_around("dent", disk, dent, 0.2, false, 0.);
}
/// Past either end of a side of a square, on the line of that side at rest and of its tangent at the end
/// where it is deformed: not where it ends elsewhere, nor further than asked.
void go_past_ends(const Field<2> &disk)
{
  const dealii::Point<2> c = Field<2>::center();
  const OutlineSurface square({c + dealii::Point<2>(-1.5, -1.5), c + dealii::Point<2>(1.5, -1.5),
                               c + dealii::Point<2>(1.5, 1.5), c + dealii::Point<2>(-1.5, 1.5)},
                              {0, 4}, {1, 1, 1, 1});
  Ray<2> ray;
  ray.direction = dealii::Tensor<1, 2>({1., 0.2}) / std::hypot(1., 0.2);
  ray.across[0] = dealii::Tensor<1, 2>({-0.2, 1.}) / std::hypot(1., 0.2);
  ray.origin = c;
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(disk.field.n_dofs());
  const SurfacePlace<2> begin = square.at(1, 0.), end = square.beyond_edge(square.at(2, 0.));
  for (const bool at_end : {false, true})
  {
    const SurfacePlace<2> &corner = at_end ? end : begin;
    const auto past = [&](const double way, const Eigen::VectorXd &nodal)
    {
      const dealii::Tensor<1, 2> x = corner.position - c + way * corner.tangent[0];
      ray.offset[0] = x * ray.across[0];
      RaySide<2> side = meet_past_end(ray, disk.field, nodal, corner, 0.2);
      if (side.met)
        side.find_functions(disk.field);
      return side;
    };
    const double out = at_end ? 1. : -1.;
    const RaySide<2> side = past(0.1 * out, still);
    std::cout << "past " << (at_end ? "the end" : "the begin") << ": on the line of the side "
              << (side.met &&
                  std::abs(side.height * ray.direction[0] + ray.offset[0] * ray.across[0][0] - 1.5) < 1e-12)
              << ", too far " << past(0.3 * out, still).met << ", before it " << past(-0.1 * out, still).met
              << '\n';
    check_derivatives<2>(at_end ? "past the end" : "past the begin", disk, ray,
                         [&](const Eigen::VectorXd &nodal) { return past(0.1 * out, nodal); });
  }
}
} // namespace

int main()
{
  const Field<2> disk("bspline");
  const Ball<2> circle(Field<2>::center(), 2.3);
  check<2>("disk", disk, circle, circle.at(some_ray<2>().direction));
  const OutlineSurface outline = ellipse(Field<2>::center(), 2.3, 2.3, 128);
  check<2>("outline", disk, outline, outline.at(5, 0.));
  const Field<3> ball("bspline");
  const Ball<3> sphere(Field<3>::center(), 2.3);
  check<3>("ball", ball, sphere, sphere.at(some_ray<3>().direction));
  check_curve();
  // A ray beside a square meets no side of it.
  Ray<2> ray;
  ray.direction = dealii::Tensor<1, 2>({1., 0.});
  ray.across[0] = dealii::Tensor<1, 2>({0., 1.});
  ray.origin = Field<2>::center();
  const dealii::Point<2> c = Field<2>::center();
  const OutlineSurface square({c + dealii::Point<2>(-1.5, -1.5), c + dealii::Point<2>(1.5, -1.5),
                               c + dealii::Point<2>(1.5, 1.5), c + dealii::Point<2>(-1.5, 1.5)},
                              {0, 4}, {1, 1, 1, 1});
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(disk.field.n_dofs());
  for (const double offset : {0., 1.4, 1.6})
  {
    ray.offset[0] = offset;
    const RaySide<2> side = meet<2>(ray, square, disk.field, still, square.at(1, 1.));
    std::cout << "square, ray at " << offset << ": met " << side.met << ", height "
              << (side.met ? side.height : 0.) << '\n';
  }
  go_around_corners(disk);
  go_past_ends(disk);
}
