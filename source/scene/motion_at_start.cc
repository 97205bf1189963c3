// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/expression.h>
#include <softgrain/geometry/shape.h>
#include <softgrain/geometry/solid.h>
#include <softgrain/scene/motion_at_start.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
namespace
{
double width_of(const Shape<2> &shape)
{
  return shape.size();
}

double width_of(const Shape<3> &shape)
{
  return std::cbrt(shape.volume());
}

/// Whether a formula, or formulas with semicolons between them, is written as zeros.
bool is_zero(const std::string &text)
{
  return text.find_first_not_of("0.; ") == std::string::npos;
}

/// Whether a sheet or line is displaced or turned.
bool is_moved(const std::vector<Expression> &motion)
{
  return std::any_of(motion.begin(), motion.end(),
                     [](const Expression &formula) { return !is_zero(formula.text()); });
}
} // namespace

template <int dim>
bool starts_in_motion(const BodyDescription<dim> &body)
{
  // Three places that no symmetry connects: a velocity that is 0 at all of them is 0.
  const double places[3][3] = {{0.31, 0.17, -0.29}, {-0.23, 0.41, 0.13}, {0.07, -0.37, 0.22}};
  if (body.velocity.empty())
    return false;
  const double width = width_of(*body.shape);
  const std::vector<std::string> axes = {"x", "y", "z"};
  for (const Expression &component :
       vector_expression(body.velocity, {axes.begin(), axes.begin() + dim}, dim))
    for (const auto &place : places)
    {
      std::vector<double> x;
      for (unsigned int d = 0; d < dim; ++d)
        x.push_back(body.center[d] + width * place[d]);
      if (component(x) != 0.)
        return true;
    }
  return false;
}

template <int dim>
bool moved_by_more_than_walls(const Scene<dim> &scene)
{
  return !scene.loads.empty() ||
         std::any_of(scene.bodies.begin(), scene.bodies.end(),
                     [](const BodyDescription<dim> &body)
                     {
                       return !body.driven && (body.angular_velocity != 0. || !is_zero(body.body_force) ||
                                               starts_in_motion(body));
                     }) ||
         std::any_of(scene.obstacles.begin(), scene.obstacles.end(),
                     [](const ObstacleDescription<dim> &obstacle) { return is_moved(obstacle.motion); });
}

template bool starts_in_motion(const BodyDescription<2> &);
template bool starts_in_motion(const BodyDescription<3> &);
template bool moved_by_more_than_walls(const Scene<2> &);
template bool moved_by_more_than_walls(const Scene<3> &);
} // namespace softgrain
