// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/parallel.h>
#include <softgrain/mpm/body/solid_builder.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
using Place = dealii::Point<3>;
using Vector = dealii::Tensor<1, 3>;

constexpr unsigned int n_columns = 8; ///< of a cut part, in either direction
constexpr double no_part = 1e-9;      ///< share of a part that holds no point

/// Volume and centroid of what a cube holds of a shape.
struct Part
{
  double volume = 0.;
  Vector moment;
};

/// The coordinate along @p axis at which a column leaves or enters the shape, between two places of either
/// side.
double crossing(const Shape<3> &shape, const unsigned int axis, Place inside, Place outside)
{
  for (unsigned int halving = 0; halving < 40; ++halving)
  {
    Place middle = inside;
    middle[axis] = 0.5 * (inside[axis] + outside[axis]);
    (shape.depth(middle) > 0. ? inside : outside) = middle;
  }
  return 0.5 * (inside[axis] + outside[axis]);
}

/// The cube from @p lower with edge @p size that the surface may cut.
Part cut(const Shape<3> &shape, const Place &lower, const double size)
{
  // Columns along which the depth changes most end at the surface at once.
  unsigned int axis = 0;
  double steepest = -1.;
  for (unsigned int d = 0; d < 3; ++d)
  {
    Place a = lower, b = lower;
    for (unsigned int e = 0; e < 3; ++e)
      a[e] = b[e] = lower[e] + 0.5 * size;
    a[d] -= 0.25 * size;
    b[d] += 0.25 * size;
    if (const double slope = std::abs(shape.depth(b) - shape.depth(a)); slope > steepest)
    {
      steepest = slope;
      axis = d;
    }
  }
  const unsigned int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const double width = size / n_columns;
  Part part;
  for (unsigned int m = 0; m < n_columns; ++m)
    for (unsigned int n = 0; n < n_columns; ++n)
    {
      Place low = lower;
      low[i] += (m + 0.5) * width;
      low[j] += (n + 0.5) * width;
      Place high = low;
      high[axis] += size;
      const bool low_in = shape.depth(low) > 0., high_in = shape.depth(high) > 0.;
      if (!low_in && !high_in)
        continue;
      double from = low[axis], to = high[axis];
      if (!low_in)
        from = crossing(shape, axis, high, low);
      if (!high_in)
        to = crossing(shape, axis, low, high);
      const double volume = width * width * (to - from);
      Place middle = low;
      middle[axis] = 0.5 * (from + to);
      part.volume += volume;
      part.moment += volume * (middle - Place());
    }
  return part;
}
} // namespace

GeneratedPoints<3>
generate_points(const Shape<3> &shape, const Lattice<3> &lattice, const unsigned int per_direction)
{
  const double size = lattice.cell_size() / per_direction;
  const auto [lower, upper] = shape.bounding_box();
  std::array<int, 3> first{}, n{};
  for (unsigned int d = 0; d < 3; ++d)
  {
    first[d] = static_cast<int>(std::floor((lower[d] - lattice.lower()[d]) / size));
    n[d] = static_cast<int>(std::floor((upper[d] - lattice.lower()[d]) / size)) - first[d] + 1;
  }
  const std::size_t n_parts = static_cast<std::size_t>(n[0]) * n[1] * n[2];
  std::vector<Part> parts(n_parts);
  parallel_for(n_parts, 64,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t p = begin; p < end; ++p)
                 {
                   Place corner = lattice.lower(), middle;
                   std::size_t rest = p;
                   for (unsigned int d = 0; d < 3; ++d)
                   {
                     corner[d] += (first[d] + static_cast<int>(rest % n[d])) * size;
                     middle[d] = corner[d] + 0.5 * size;
                     rest /= n[d];
                   }
                   const double depth = shape.depth(middle), reach = 0.5 * std::sqrt(3.) * size;
                   if (depth > reach)
                     parts[p] = {size * size * size, size * size * size * (middle - Place())};
                   else if (depth > -reach)
                     parts[p] = cut(shape, corner, size);
                 }
               });
  GeneratedPoints<3> points;
  double sum = 0.;
  for (const Part &part : parts)
    if (part.volume > no_part * size * size * size)
    {
      points.position.push_back(Place(part.moment / part.volume));
      points.volume.push_back(part.volume);
      sum += part.volume;
    }
  for (double &volume : points.volume)
    volume *= shape.volume() / sum;
  return points;
}

namespace
{
void make_points(Body<3> &body,
                 const GeneratedPoints<3> &generated,
                 const Lattice<3> &lattice,
                 PointStore<3> &store)
{
  body.points = BodyPoints<3>(store.handler().get_property_pool(), store.layout(), store.size());
  for (unsigned int p = 0; p < generated.position.size(); ++p)
  {
    lattice.check_inside(generated.position[p], "material point");
    WritablePoint<3> point = store(store.add(generated.position[p], body.index));
    const double volume = generated.volume[p];
    point.rest_volume() = volume;
    point.mass() = body.material.density * volume;
    point.half_extent() = 0.5 * std::cbrt(volume);
    if (store.layout().has(PointSlot::volume))
      point.volume() = volume;
    point.gradient() = dealii::unit_symmetric_tensor<3>();
    if (body.material.law->n_history() > 0)
      body.material.law->initial_history(point.history());
    body.rest.area += volume;
  }
  body.n_points = generated.position.size();
  body.points.renew(store.handler().get_property_pool(), store.by_body({nullptr})[0]);
}

/// A field with fewer nodes on its rim has fewer modes without a minimum, and is stiffer under light
/// contacts. With inertia no mode lacks a minimum, and the law that makes up for the stiffness is one of
/// balls in balance.
double fill_limit_of(const Shape<3> &shape, const Settings &settings)
{
  if (settings.fill_limit > 0.)
    return settings.fill_limit;
  return shape.round() && settings.scheme.ends_in_balance() ? 0.95 : 0.6;
}

/// The first grid, under points that are sorted.
void lay_grid(Body<3> &body,
              const double fill_limit,
              const ShapeFunction &function,
              const Lattice<3> &lattice,
              const std::vector<Place> &markers)
{
  std::vector<Place> position;
  std::vector<double> volume, half_extent;
  for (unsigned int p = 0; p < body.points.size(); ++p)
  {
    const auto point = body.points[p];
    position.push_back(point.position());
    volume.push_back(point.rest_volume());
    half_extent.push_back(point.half_extent());
  }
  body.field.build(lattice, function, {position, volume, half_extent, markers}, fill_limit);
  std::vector<double> mass(body.field.nodes().n(), 0.);
  for (unsigned int p = 0; p < body.points.size(); ++p)
    for (unsigned int k = 0; k < body.field.cells().nodes_per_cell(); ++k)
      mass[body.field.at_point(p).nodes[k]] += body.points[p].mass() * body.field.at_point(p).values[k];
  body.nodes.mass = body.field.extension().restrict_scalar(mass);
  body.nodes.displacement = Eigen::VectorXd::Zero(body.field.n_dofs());
  body.nodes.internal_force = body.nodes.displacement;
}
} // namespace

Body<3> make_solid(const std::string &name,
                   const Shape<3> &shape,
                   std::shared_ptr<const constitutive::Law<3>> law,
                   const double density,
                   const Settings &settings,
                   const ShapeFunction &function,
                   const Lattice<3> &lattice,
                   const std::vector<Place> &markers,
                   PointStore<3> &store)
{
  Body<3> body;
  body.name = name;
  body.material.law = std::move(law);
  body.material.density = density;
  body.material.averaged = settings.averaged_dilatation(body.material.law->poisson_ratio());
  try
  {
    for (const Place &x : markers)
      lattice.check_inside(x, "surface");
    const GeneratedPoints<3> generated = generate_points(shape, lattice, settings.points_per_direction);
    store.reserve(generated.position.size());
    make_points(body, generated, lattice, store);
    lay_grid(body, fill_limit_of(shape, settings), function, lattice, markers);
  }
  catch (const ComputationError &error)
  {
    throw InputError("'Bodies/" + name + "': " + error.what());
  }
  return body;
}
} // namespace softgrain::mpm
