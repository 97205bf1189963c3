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
dealii::Tensor<2, 2> unit()
{
  dealii::Tensor<2, 2> one;
  one[0][0] = one[1][1] = 1.;
  return one;
}

void make_points(Body<2> &body, const BodyDescription<2> &description, const BuildContext &context)
{
  const GeneratedPoints<2> generated =
      generate_points(description, context.lattice, context.settings.points_per_direction);
  const std::size_t n = generated.position.size();
  if (n == 0)
    throw InputError("'Bodies/" + description.name + "' holds no material point: its area is zero");
  PointStore<2> &store = context.points;
  body.points = BodyPoints<2>(store.handler().get_property_pool(), store.layout(), store.size());
  for (unsigned int p = 0; p < n; ++p)
  {
    context.lattice.check_inside(generated.position[p], "material point");
    PointView<2> point = store(store.add(generated.position[p], body.index));
    const double volume = generated.volume[p];
    point.rest_volume() = volume;
    point.mass() = body.density * volume;
    point.half_extent() = 0.5 * std::sqrt(volume);
    if (store.layout().has(PointSlot::volume))
      point.volume() = volume;
    point.gradient() = unit();
    if (body.law->n_history() > 0)
      body.law->initial_history(point.history());
    body.rest_area += volume;
    if (!body.body_force.empty())
      body.rest_position.push_back(point.position());
  }
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
  // Four pieces of polyline between two places that look for contact: their sagitta is then a sixteenth.
  constexpr unsigned int pieces = 4;
  const double step = context.settings.marker_spacing * context.lattice.cell_size();
  Boundary<2> &boundary = body.boundary;
  boundary.contact_stride = pieces;
  boundary.loop_start.assign(1, 0);
  for (const Polygon &coarse : description.shape->outline(step))
  {
    // A loop of a whole number of strides; disks keep their circle.
    const unsigned int n = coarse.size();
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
  boundary.smooth = description.shape->round() && !boundary.corner.empty() &&
                    std::count(boundary.corner.begin(), boundary.corner.end(), 1) == 0;
  boundary.circular =
      boundary.smooth &&
      is_circle(Polygon(boundary.position.begin(), boundary.position.begin() + boundary.loop_start[1]));
}

/// Mass, velocity and acceleration of the nodes; false when an independent node is left without mass, or
/// without positive mass where @p positive ones are asked for.
bool points_to_nodes(Body<2> &body, const bool positive)
{
  const BodyField<2> &field = body.field;
  const bool moving = body.points.layout().has(PointSlot::velocity),
             accelerated = body.points.layout().has(PointSlot::acceleration),
             affine = body.points.layout().has(PointSlot::affine);
  const unsigned int n = field.nodes_per_cell();
  std::vector<double> mass(field.n_nodes(), 0.);
  Eigen::VectorXd momentum = Eigen::VectorXd::Zero(2 * field.n_nodes()), force = momentum;
  for (unsigned int p = 0; p < body.points.size(); ++p)
  {
    const auto point = body.points[p];
    for (unsigned int k = 0; k < n; ++k)
    {
      const unsigned int i = field.point_nodes(p)[k];
      const double m = point.mass() * field.values(p)[k];
      mass[i] += m;
      dealii::Tensor<1, 2> v;
      if (moving)
        v = point.velocity();
      if (affine)
        v += point.affine() * (field.position(i) - point.position());
      for (unsigned int d = 0; d < 2; ++d)
      {
        momentum[2 * i + d] += m * v[d];
        if (accelerated)
          force[2 * i + d] += m * point.acceleration()[d];
      }
    }
  }
  body.mass = field.restrict_scalar(mass);
  if (body.mass.size() == 0 || !((positive ? body.mass.minCoeff() : body.mass.cwiseAbs().minCoeff()) > 0.))
    return false;
  const auto divide = [&](const Eigen::VectorXd &all, Eigen::VectorXd &result)
  {
    field.restrict(all, result);
    for (unsigned int i = 0; i < body.mass.size(); ++i)
      result.segment<2>(2 * i) /= body.mass[i];
  };
  if (moving)
    divide(momentum, body.velocity);
  if (accelerated)
    divide(force, body.acceleration);
  return true;
}
} // namespace

void lay_grid(Body<2> &body, const BuildContext &context)
{
  const std::size_t n = body.points.size();
  std::vector<dealii::Point<2>> position(n);
  std::vector<double> volume(n), half_extent(n);
  for (unsigned int p = 0; p < n; ++p)
  {
    const auto point = body.points[p];
    position[p] = point.position();
    half_extent[p] = point.half_extent();
    volume[p] = body.small_strain() ? point.volume() : point.rest_volume() * determinant(point.gradient());
  }
  // Extrapolation has negative weights, and a node between several poorly filled cells may be left with a
  // negative mass. Then some of these cells have to count as well filled; at last all that hold points do,
  // and masses are positive. Functions that are negative in places are for schemes without inertia, where
  // masses are no more than weights.
  for (double limit = context.settings.fill_limit;; limit *= 0.5)
  {
    body.field.build(context.lattice, context.shape,
                     {position, volume, half_extent, body.boundary.grid_position}, limit);
    if (points_to_nodes(body, context.shape.nowhere_negative()))
      break;
    if (limit < 1e-4)
      throw ComputationError("body '" + body.name +
                             "': a node has no positive mass; refine 'Mesh/Cell size'");
  }
  body.displacement = Eigen::VectorXd::Zero(body.field.n_dofs());
  body.velocity_of_points = body.velocity;
}

std::vector<dealii::Point<2>> places_reached(const Body<2> &body, const Lattice<2> &lattice)
{
  Eigen::VectorXd u;
  body.field.prolongate(body.displacement, u);
  std::vector<dealii::Point<2>> places(body.points.size());
  for (unsigned int p = 0; p < places.size(); ++p)
  {
    places[p] = body.points[p].position();
    for (unsigned int k = 0; k < body.field.nodes_per_cell(); ++k)
      for (unsigned int d = 0; d < 2; ++d)
        places[p][d] += body.field.values(p)[k] * u[2 * body.field.point_nodes(p)[k] + d];
    lattice.check_inside(places[p], "material point of body '" + body.name + "'");
  }
  for (const dealii::Point<2> &x : body.boundary.position)
    lattice.check_inside(x, "boundary marker of body '" + body.name + "'");
  return places;
}

void leave_grid(Body<2> &body, const std::vector<dealii::Point<2>> &places, const BuildContext &context)
{
  const BodyField<2> &field = body.field;
  const bool moving = body.points.layout().has(PointSlot::velocity),
             accelerated = body.points.layout().has(PointSlot::acceleration),
             affine = moving && body.points.layout().has(PointSlot::affine);
  const double pic = context.settings.pic_fraction, h = context.lattice.cell_size();
  const unsigned int n = field.nodes_per_cell();
  Eigen::VectorXd u, v, before, a;
  field.prolongate(body.displacement, u);
  if (moving)
  {
    field.prolongate(body.velocity, v);
    field.prolongate(body.velocity_of_points, before);
  }
  if (accelerated)
    field.prolongate(body.acceleration, a);
  for (unsigned int p = 0; p < body.points.size(); ++p)
  {
    auto point = body.points[p];
    const unsigned int *nodes = field.point_nodes(p);
    const double *value = field.values(p);
    const auto *slope = field.slopes(p);
    dealii::Tensor<1, 2> interpolated, increment, acceleration;
    dealii::Tensor<2, 2> gradient = unit(), rate, moment, spread;
    for (unsigned int k = 0; k < n; ++k)
    {
      const dealii::Tensor<1, 2> uk({u[2 * nodes[k]], u[2 * nodes[k] + 1]});
      gradient += outer_product(uk, slope[k]);
      if (!moving)
        continue;
      const dealii::Tensor<1, 2> vk({v[2 * nodes[k]], v[2 * nodes[k] + 1]}),
          bk({before[2 * nodes[k]], before[2 * nodes[k] + 1]});
      const dealii::Tensor<1, 2> arm = field.position(nodes[k]) - point.position();
      interpolated += value[k] * vk;
      increment += value[k] * (vk - bk);
      rate += outer_product(vk, slope[k]);
      moment += value[k] * outer_product(vk, arm);
      spread += value[k] * outer_product(arm, arm);
      if (accelerated)
        acceleration += value[k] * dealii::Tensor<1, 2>({a[2 * nodes[k]], a[2 * nodes[k] + 1]});
    }
    point.move_to(context.lattice.off_faces(places[p]));
    point.gradient() = gradient * point.gradient();
    if (body.small_strain() && !body.driven) // what is driven is never stressed
      point.volume() = body.step.volume[p];
    if (moving)
      point.velocity() = pic * interpolated + (1. - pic) * (point.velocity() + increment);
    if (accelerated)
      point.acceleration() = acceleration;
    if (affine)
    {
      // APIC's B D^-1; hats lose D at a node, where B D^-1 is the velocity gradient anyway (Jiang et al.
      // 2015).
      point.velocity() = interpolated;
      point.affine() = context.shape.degree() > 1 && determinant(spread) > 1e-8 * std::pow(h, 4)
                           ? moment * invert(spread)
                           : rate;
    }
  }
  body.boundary.grid_position = body.boundary.position;
}

void move_boundary(Body<2> &body)
{
  for (unsigned int m = 0; m < body.boundary.position.size(); ++m)
  {
    const NodeWeights &weights = body.field.marker_weights(m);
    dealii::Tensor<1, 2> moved;
    for (unsigned int k = 0; k < weights.node.size(); ++k)
      for (unsigned int d = 0; d < 2; ++d)
        moved[d] += weights.weight[k] * body.displacement[2 * weights.node[k] + d];
    body.boundary.position[m] = body.boundary.grid_position[m] + moved;
  }
}

double grid_distortion(const Body<2> &body)
{
  double worst = 1.;
  for (const dealii::Tensor<2, 2> &G : body.step.grid_gradient)
  {
    // Singular values of a 2x2 matrix from its norm and determinant.
    const double sum = G.norm_square(), product = std::abs(determinant(G));
    const double root = std::sqrt(std::max(0., sum * sum - 4. * product * product));
    worst = std::max(worst, std::sqrt((sum + root) / std::max(sum - root, 1e-300)));
  }
  return worst;
}

Body<2> make_body(const BodyDescription<2> &description,
                  const unsigned int index,
                  std::shared_ptr<const constitutive::Law<2>> law,
                  const double density,
                  const BuildContext &context)
{
  Body<2> body;
  body.name = description.name;
  body.index = index;
  body.law = std::move(law);
  body.density = density;
  body.driven = description.driven;
  body.f_bar = context.settings.f_bar == "on" ||
               (context.settings.f_bar == "automatic" && body.law->poisson_ratio() > 0.47);
  // The parameter's default says that there is no load, and then none is evaluated.
  if (!description.body_force.empty() && description.body_force != "0; 0")
    body.body_force = vector_expression(description.body_force, {"x", "y", "X", "Y", "t"});
  make_boundary(body, description, context);
  try
  {
    for (const dealii::Point<2> &x : body.boundary.position)
      context.lattice.check_inside(x, "boundary marker");
    make_points(body, description, context);
  }
  catch (const ComputationError &error)
  {
    throw InputError("'Bodies/" + description.name + "': " + error.what());
  }
  return body;
}

void start_body(Body<2> &body, const BodyDescription<2> &description, const BuildContext &context)
{
  try
  {
    lay_grid(body, context);
  }
  catch (const ComputationError &error)
  {
    throw InputError("'Bodies/" + description.name + "': " + error.what());
  }

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
  if (body.driven)
  {
    body.drive = velocity_at(description.center);
    if (description.angular_velocity != 0.)
      throw InputError("'Bodies/" + description.name +
                       "/Angular velocity' is not allowed for a driven body: it moves without turning");
  }
  for (unsigned int i = 0; body.velocity.size() > 0 && i < body.field.n_independent(); ++i)
  {
    const auto v =
        body.driven ? body.drive : velocity_at(body.field.position(body.field.node_of_independent(i)));
    for (unsigned int d = 0; d < 2; ++d)
      body.velocity[2 * i + d] = v[d];
  }
  body.velocity_of_points = body.velocity;
  for (unsigned int p = 0; p < body.points.size(); ++p)
  {
    auto point = body.points[p];
    if (body.points.layout().has(PointSlot::velocity))
      point.velocity() = body.driven ? body.drive : velocity_at(point.position());
    if (body.points.layout().has(PointSlot::affine))
      point.affine() =
          dealii::Tensor<2, 2>({{0., -description.angular_velocity}, {description.angular_velocity, 0.}});
  }
  if (context.settings.scheme.stored_acceleration)
    body.acceleration = Eigen::VectorXd::Zero(body.field.n_dofs());
  body.internal_force = Eigen::VectorXd::Zero(body.field.n_dofs());
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
