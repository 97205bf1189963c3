// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/expression.h>
#include <softgrain/geometry/shapes_2d.h>
#include <softgrain/mpm/body/body_builder.h>
#include <softgrain/mpm/body/point_generator.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
/// Says of which body it is what @p work throws.
template <class Work>
void of_body(const BodyDescription<2> &description, const Work &work)
{
  try
  {
    work();
  }
  catch (const ComputationError &error)
  {
    throw InputError("'Bodies/" + description.name + "': " + error.what());
  }
}

void make_points(Body<2> &body, const BodyDescription<2> &description, const BuildContext &context)
{
  const GeneratedPoints<2> generated =
      generate_points(description, context.lattice, context.settings.points_per_direction, body.levels.get());
  const std::size_t n = generated.position.size();
  if (n == 0)
    throw InputError("'Bodies/" + description.name + "' holds no material point: its area is zero");
  PointStore<2> &store = context.points;
  body.points = BodyPoints<2>(store.handler().get_property_pool(), store.layout(), store.size());
  for (unsigned int p = 0; p < n; ++p)
  {
    context.lattice.check_inside(generated.position[p], "material point");
    WritablePoint<2> point = store(store.add(generated.position[p], body.index));
    const double volume = generated.volume[p];
    point.rest_volume() = volume;
    point.mass() = body.material.density * volume;
    point.half_extent() = 0.5 * std::sqrt(volume);
    if (store.layout().has(PointSlot::volume))
      point.volume() = volume;
    point.gradient() = dealii::Tensor<2, 2>({{1., 0.}, {0., 1.}});
    if (body.material.law->n_history() > 0)
      body.material.law->initial_history(point.history());
    body.rest.area += volume;
    if (body.loads.look_at_points())
      body.rest.position.push_back(point.position());
  }
  body.n_points = n;
}

/// A corner turns by more than any marker of a round outline.
void find_corners(Boundary<2> &boundary)
{
  constexpr double cosine = 0.9;
  boundary.corner.resize(boundary.position.size());
  for (unsigned int m = 0; m < boundary.position.size(); ++m)
  {
    const dealii::Tensor<1, 2> before = boundary.position[m] - boundary.position[boundary.previous(m)],
                               after = boundary.position[boundary.next(m)] - boundary.position[m];
    boundary.corner[m] = before * after < cosine * before.norm() * after.norm();
  }
}

/// Whether all vertices are as far from their middle.
bool is_circle(const Polygon &loop)
{
  dealii::Point<2> middle;
  for (const dealii::Point<2> &x : loop)
    middle += (x - dealii::Point<2>()) / static_cast<double>(loop.size());
  const double radius = loop.front().distance(middle);
  return std::all_of(loop.begin(), loop.end(),
                     [&](const dealii::Point<2> &x)
                     { return std::abs(x.distance(middle) - radius) < 1e-6 * radius; });
}

void make_boundary(Body<2> &body, const BodyDescription<2> &description, const BuildContext &context)
{
  // Four pieces of polyline between two samples: their sagitta is then a sixteenth.
  constexpr unsigned int pieces = 4;
  const double step = context.settings.marker_spacing * context.lattice.cell_size();
  Boundary<2> &boundary = body.boundary;
  boundary.stride = pieces;
  boundary.spacing = step;
  boundary.loop_start.assign(1, 0);
  for (const Polygon &coarse : description.shape->outline(step))
  {
    // A loop of a whole number of strides; disks keep their circle.
    const unsigned int n = coarse.size();
    boundary.grid_position.reserve(boundary.grid_position.size() + n * pieces);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int k = 0; k < pieces; ++k)
      {
        const dealii::Point<2> on_edge =
            coarse[i] + (static_cast<double>(k) / pieces) * (coarse[(i + 1) % n] - coarse[i]);
        boundary.grid_position.push_back(description.shape->project(on_edge, coarse[i]));
      }
    boundary.loop_start.push_back(boundary.grid_position.size());
  }
  boundary.position = boundary.grid_position;
  find_corners(boundary);
  boundary.circular = description.shape->round() && !boundary.corner.empty() &&
                      std::count(boundary.corner.begin(), boundary.corner.end(), 1) == 0 &&
                      boundary.n_loops() == 1 && is_circle(boundary.position);
}
} // namespace

Body<2> make_body(const BodyDescription<2> &description,
                  const unsigned int index,
                  std::shared_ptr<const constitutive::Law<2>> law,
                  const double density,
                  const BuildContext &context,
                  std::shared_ptr<const CellLevels<2>> levels)
{
  Body<2> body;
  body.name = description.name;
  body.index = index;
  body.material.law = std::move(law);
  body.material.density = density;
  body.rigid.driven = description.driven;
  body.material.averaged = context.settings.averaged_dilatation(body.material.law->poisson_ratio());
  body.levels = std::move(levels);
  make_boundary(body, description, context);
  of_body(description,
          [&]()
          {
            for (const dealii::Point<2> &x : body.boundary.position)
              context.lattice.check_inside(x, "boundary marker");
          });
  return body;
}

void fill_body(Body<2> &body, const BodyDescription<2> &description, const BuildContext &context)
{
  of_body(description, [&]() { make_points(body, description, context); });
}

void start_body(Body<2> &body, const BodyDescription<2> &description, const BuildContext &context)
{
  of_body(description, [&]() { lay_grid(body, context); });

  // Formulas are taken at the nodes, so that affine motions are exact; the points follow.
  std::vector<Expression> formulas;
  if (!description.velocity.empty() && description.velocity != "0; 0")
    formulas = vector_expression(description.velocity, {"x", "y"});
  const auto velocity_at = [&](const dealii::Point<2> &x)
  {
    const dealii::Tensor<1, 2> arm = x - description.center;
    dealii::Tensor<1, 2> v({-description.angular_velocity * arm[1], description.angular_velocity * arm[0]});
    for (unsigned int d = 0; d < formulas.size(); ++d)
      v[d] += formulas[d]({x[0], x[1]});
    return v;
  };
  if (body.rigid.driven)
  {
    body.rigid.drive = velocity_at(description.center);
    if (description.angular_velocity != 0.)
      throw InputError("'Bodies/" + description.name +
                       "/Angular velocity' is not allowed for a driven body: it moves without turning");
  }
  for (unsigned int i = 0; body.nodes.velocity.size() > 0 && i < body.field.n_independent(); ++i)
  {
    const auto v = body.rigid.driven ? body.rigid.drive : velocity_at(body.field.place(i));
    for (unsigned int d = 0; d < 2; ++d)
      body.nodes.velocity[2 * i + d] = v[d];
  }
  body.nodes.velocity_of_points = body.nodes.velocity;
  for (unsigned int p = 0; p < body.points.size(); ++p)
  {
    auto point = body.points[p];
    if (body.points.layout().has(PointSlot::velocity))
      point.velocity() = body.rigid.driven ? body.rigid.drive : velocity_at(point.position());
    if (body.points.layout().has(PointSlot::affine))
      point.affine() =
          dealii::Tensor<2, 2>({{0., -description.angular_velocity}, {description.angular_velocity, 0.}});
  }
  body.nodes.internal_force = Eigen::VectorXd::Zero(body.field.n_dofs());
}

BodyDescription<2> wall_slab(const WallDescription<2> &wall, const BuildContext &context)
{
  const unsigned int axis = std::abs(wall.normal[0]) > std::abs(wall.normal[1]) ? 0 : 1;
  if (std::abs(std::abs(wall.normal[axis]) - 1.) > 1e-12)
    throw InputError(
        "'Walls/" + wall.name +
        "/Normal' is not allowed with 'Type' = 'material points': it must be parallel to an axis");
  const double h = context.lattice.cell_size(), thickness = 3. * h;
  const auto &settings = context.settings;
  BodyDescription<2> slab;
  slab.name = wall.name;
  slab.driven = true;
  dealii::Tensor<1, 2> edges;
  edges[axis] = thickness;
  edges[1 - axis] = settings.mesh_upper[1 - axis] - settings.mesh_lower[1 - axis] - 2. * h;
  slab.center[axis] = wall.point[axis] - 0.5 * thickness * wall.normal[axis];
  slab.center[1 - axis] = 0.5 * (settings.mesh_upper[1 - axis] + settings.mesh_lower[1 - axis]);
  if (slab.center[axis] - 0.5 * thickness < settings.mesh_lower[axis] + h ||
      slab.center[axis] + 0.5 * thickness > settings.mesh_upper[axis] - h || edges[1 - axis] <= 0.)
    throw InputError("'Walls/" + wall.name +
                     "' is made of material points and needs four cells of mesh behind its face: enlarge "
                     "'Mesh/Lower' and 'Mesh/Upper'");
  slab.shape = std::make_shared<Rectangle2D>(slab.center, edges);
  return slab;
}
} // namespace softgrain::mpm
