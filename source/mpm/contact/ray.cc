// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/ray.h>
#include <softgrain/mpm/field/field_near.h>

#include <cmath>
#include <limits>

namespace softgrain::mpm
{
namespace
{
/// Of Newton's method; it is quadratic from a place nearby.
constexpr unsigned int max_iterations = 40;
constexpr double half_piece = 0.1; ///< that is seen as one where a field has kinks [cells]
constexpr double rounding = 1e-14; ///< of a place, over its distance from the origin
/// After a move by so much [cells] the error is its square: rounding.
constexpr double last_move = 1e-7;

/// What a rigid surface has in place of the field of a body.
template <int dim>
struct NoField
{
  using Vector = dealii::Tensor<1, dim>;
  bool look_at(const dealii::Point<dim> &) { return true; }
  void find_curvature() {}
  Vector along(const Vector &) const { return Vector(); }
  Vector along(const Vector &, const Vector &) const { return Vector(); }
  double cell_size() const { return 0.; }
  Vector value;
};

/// The deformed surface at a place.
template <int dim>
struct Deformed
{
  template <class Field>
  Deformed(const SurfacePlace<dim> &place, const Field &field) : position(place.position + field.value)
  {
    for (unsigned int k = 0; k < dim - 1; ++k)
      tangent[k] = place.tangent[k] + field.along(place.tangent[k]);
  }

  dealii::Point<dim> position;
  std::array<dealii::Tensor<1, dim>, dim - 1> tangent;
};

/// J_ij = across_i · x_j.
template <int dim>
dealii::Tensor<2, dim - 1> jacobian(const Ray<dim> &ray, const Deformed<dim> &surface)
{
  dealii::Tensor<2, dim - 1> J;
  for (unsigned int i = 0; i < dim - 1; ++i)
    for (unsigned int j = 0; j < dim - 1; ++j)
      J[i][j] = ray.across[i] * surface.tangent[j];
  return J;
}

/// A surface that stands along the ray, or has been turned over, has no height.
template <int n>
bool stands_along(const dealii::Tensor<2, n> &J)
{
  return !(determinant(J) * determinant(J) > 1e-6);
}

/// Gives a side that has been met its height and derivatives. @param bends whether second ones, too
template <int dim, class Field>
void derive(const Ray<dim> &ray,
            const Deformed<dim> &surface,
            const dealii::Tensor<2, dim - 1> &inverse,
            const bool bends,
            Field &field,
            RaySide<dim> &side)
{
  side.height = (surface.position - ray.origin) * ray.direction;
  side.normal = ray.direction;
  for (unsigned int i = 0; i < dim - 1; ++i)
  {
    double slope = 0.;
    for (unsigned int j = 0; j < dim - 1; ++j)
    {
      slope += inverse[j][i] * (ray.direction * surface.tangent[j]);
      side.way[i] -= inverse[i][j] * ray.across[j];
    }
    side.normal -= slope * ray.across[i];
  }
  if (!bends)
    return;
  field.find_curvature();
  for (unsigned int i = 0; i < dim - 1; ++i)
    for (unsigned int j = 0; j < dim - 1; ++j)
    {
      const dealii::Tensor<1, dim> &a = side.place.tangent[i], &b = side.place.tangent[j];
      // The place goes on along the surface at rest, which bends, and the field bends it further.
      dealii::Tensor<1, dim> second = field.along(a, b);
      second -= side.place.bend[i][j] * (side.place.normal + field.along(side.place.normal));
      side.sliding_twice += (side.normal * second) * outer_product(side.way[i], side.way[j]);
    }
}

/// Moves a side that has been met but for @p off to the ray, where its height and normal are known to first
/// order.
template <int dim>
void move_on(const Ray<dim> &ray,
             const Deformed<dim> &surface,
             const dealii::Tensor<1, dim - 1> &off,
             const SurfacePlace<dim> &next,
             const dealii::Tensor<1, dim - 1> &way,
             RaySide<dim> &side)
{
  side.place = next;
  for (unsigned int i = 0; i < dim - 1; ++i)
  {
    side.height += way[i] * (surface.tangent[i] * ray.direction);
    for (unsigned int j = 0; j < dim - 1; ++j)
      side.normal += (ray.across[i] * (side.sliding_twice * ray.across[j])) * off[j] * ray.across[i];
  }
}

/// Where the field has kinks at the sides of cells, there is no direction in which a force at a kink acts,
/// and Newton's method goes from one side to the other. So slope and bending of the surface are those of a
/// short piece of it, which reaches as far to one side of the place as to the other: both change without
/// jumps while the place slides.
void round_off(const Ray<2> &ray, const RestSurface<2> &surface, FieldNear<2> &near, RaySide<2> &side)
{
  const double rounded = half_piece * near.cell_size();
  std::array<double, 2> y, height, slope;
  for (const unsigned int end : {0, 1})
  {
    dealii::Tensor<1, 1> way;
    way[0] = end == 0 ? -rounded : rounded;
    const SurfacePlace<2> place = surface.move(side.place, way);
    if (!near.look_at(place.position))
      return;
    const Deformed<2> here(place, near);
    const double along = ray.across[0] * here.tangent[0];
    if (!(std::abs(along) > 1e-3))
      return;
    y[end] = (here.position - ray.origin) * ray.across[0];
    height[end] = (here.position - ray.origin) * ray.direction;
    slope[end] = (ray.direction * here.tangent[0]) / along;
  }
  side.normal = ray.direction - (height[1] - height[0]) / (y[1] - y[0]) * ray.across[0];
  side.sliding_twice = (slope[1] - slope[0]) / (y[1] - y[0]) * outer_product(ray.across[0], ray.across[0]);
}

template <int dim, class Field>
RaySide<dim> meet_deformed(const Ray<dim> &ray,
                           const RestSurface<dim> &surface,
                           Field &near,
                           const SurfacePlace<dim> &guess,
                           const bool bends)
{
  RaySide<dim> side;
  side.place = guess;
  double before = std::numeric_limits<double>::max();
  for (unsigned int iteration = 0; iteration < max_iterations; ++iteration)
  {
    if (!near.look_at(side.place.position))
      return side;
    const Deformed<dim> here(side.place, near);
    const dealii::Tensor<2, dim - 1> J = jacobian(ray, here);
    if (stands_along(J))
      return side;
    const dealii::Tensor<2, dim - 1> inverse = invert(J);
    dealii::Tensor<1, dim - 1> off;
    for (unsigned int i = 0; i < dim - 1; ++i)
      off[i] = (here.position - ray.origin) * ray.across[i] - ray.offset[i];
    const dealii::Tensor<1, dim - 1> way = -1. * (inverse * off);
    const double error = off.norm();
    // Rounding is reached, or the error does not fall any more, or will be rounding after the next move.
    const double distance = (here.position - dealii::Point<dim>()).norm();
    const bool done = error <= rounding * distance || (error >= 0.5 * before && error < 1e-9 * distance),
               last = error < last_move * near.cell_size();
    if (done || last)
    {
      side.met = true;
      derive(ray, here, inverse, bends, near, side);
      if (!done)
        move_on(ray, here, off, surface.move(side.place, way), way, side);
      return side;
    }
    before = error;
    const SurfacePlace<dim> next = surface.move(side.place, way);
    if (next.at_edge && side.place.at_edge && next.position.distance(side.place.position) == 0.)
      return side;
    side.place = next;
  }
  return side;
}
} // namespace

template <int dim>
RaySide<dim> meet(const Ray<dim> &ray,
                  const RestSurface<dim> &surface,
                  const BodyField<dim> &field,
                  const Eigen::VectorXd &nodal,
                  const SurfacePlace<dim> &guess,
                  const bool bends)
{
  FieldNear<dim> near(field, nodal);
  RaySide<dim> side = meet_deformed(ray, surface, near, guess, bends);
  if constexpr (dim == 2)
    if (side.met && bends && !field.smooth())
      round_off(ray, surface, near, side);
  return side;
}

RaySide<2> meet_around(const Ray<2> &ray,
                       const RestSurface<2> &surface,
                       const BodyField<2> &field,
                       const Eigen::VectorXd &nodal,
                       const SurfacePlace<2> &corner)
{
  const SurfacePlace<2> beyond = surface.beyond_edge(corner);
  const bool goes_on = corner.along > 0.;
  const dealii::Tensor<1, 2> &before = (goes_on ? corner : beyond).tangent[0],
                             &after = (goes_on ? beyond : corner).tangent[0];
  FieldNear<2> near(field, nodal);
  // In a dent the other side is met by rays of its own.
  if (beyond.piece == corner.piece || before[0] * after[1] - before[1] * after[0] <= 0. ||
      !near.look_at(corner.position))
    return RaySide<2>();
  const double here = ray.across[0] * Deformed<2>(corner, near).tangent[0],
               there = ray.across[0] * Deformed<2>(beyond, near).tangent[0];
  return here * there > 0. ? meet(ray, surface, field, nodal, beyond) : RaySide<2>();
}

RaySide<2> meet_past_end(const Ray<2> &ray,
                         const BodyField<2> &field,
                         const Eigen::VectorXd &nodal,
                         const SurfacePlace<2> &corner,
                         const double reach)
{
  RaySide<2> side;
  FieldNear<2> near(field, nodal);
  if (!near.look_at(corner.position))
    return side;
  const Deformed<2> here(corner, near);
  const double slope = ray.across[0] * here.tangent[0],
               off = (here.position - ray.origin) * ray.across[0] - ray.offset[0];
  if (!(std::abs(slope) > 1e-3))
    return side;
  const double way = -off / slope;
  if ((way > 0.) != (corner.along > 0.) || std::abs(way) > reach)
    return side;
  side.met = true;
  side.place = corner;
  side.past_end = way;
  side.height = (here.position + way * here.tangent[0] - ray.origin) * ray.direction;
  side.normal = ray.direction - (ray.direction * here.tangent[0]) / slope * ray.across[0];
  side.way[0] = -1. / slope * ray.across[0];
  return side;
}

template <int dim>
RaySide<dim> meet(const Ray<dim> &ray, const RestSurface<dim> &surface, const SurfacePlace<dim> &guess)
{
  NoField<dim> none;
  return meet_deformed(ray, surface, none, guess, true);
}

template <int dim>
RaySide<dim> side_at(const Ray<dim> &ray, const SurfacePlace<dim> &place)
{
  NoField<dim> none;
  RaySide<dim> side;
  side.place = place;
  const Deformed<dim> here(place, none);
  const dealii::Tensor<2, dim - 1> J = jacobian(ray, here);
  if (!stands_along(J))
  {
    side.met = true;
    derive(ray, here, invert(J), true, none, side);
  }
  return side;
}

template RaySide<3> side_at(const Ray<3> &, const SurfacePlace<3> &);
template RaySide<2> meet(const Ray<2> &, const RestSurface<2> &, const SurfacePlace<2> &);
template RaySide<3> meet(const Ray<3> &, const RestSurface<3> &, const SurfacePlace<3> &);
template RaySide<2> meet(const Ray<2> &,
                         const RestSurface<2> &,
                         const BodyField<2> &,
                         const Eigen::VectorXd &,
                         const SurfacePlace<2> &,
                         bool);
template RaySide<3> meet(const Ray<3> &,
                         const RestSurface<3> &,
                         const BodyField<3> &,
                         const Eigen::VectorXd &,
                         const SurfacePlace<3> &,
                         bool);
} // namespace softgrain::mpm
