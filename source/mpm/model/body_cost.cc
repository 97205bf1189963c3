// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/field/shape_function.h>
#include <softgrain/mpm/model/body_cost.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
/// Constants fitted to processor time and peak memory of runs of the shipped scenes on one thread.
namespace fitted
{
constexpr double boundary = 0.34;    ///< cells beside the boundary that get points
constexpr double near_contact = 0.5; ///< smaller cells of a level, per cell of its size along the outline
constexpr double factor_seconds = 1.2e-10;  ///< of a row of a band matrix, per square of its width
constexpr double sparse_seconds = 2.2e-8;   ///< of a sparse factorisation, per power 3/2 of the unknowns
constexpr double condense_seconds = 1.6e-8; ///< of one body to its contact rows, in the same way
constexpr double point_memory = 4.6e3;      ///< [bytes]
} // namespace fitted
} // namespace

BodyCost cost_of(const BodyGroup &body, const Settings &settings)
{
  const double h = settings.cell_size, per_cell = std::pow(settings.points_per_direction, 2);
  double cells = (body.area + fitted::boundary * h * body.perimeter) / (h * h);
  // Each level puts cells of its size along what is near contact.
  for (unsigned int l = 1; l <= settings.refine_near_contact; ++l)
    cells += fitted::near_contact * body.perimeter / std::ldexp(h, -static_cast<int>(l));
  BodyCost cost;
  cost.points = std::max(1., per_cell * cells);
  cost.memory = fitted::point_memory * cost.points;
  if (body.driven)
    return cost;
  const double per_edge = create_shape_function(settings.shape)->nodes_per_edge();
  cost.unknowns = 2. * cells * per_edge * per_edge;
  if (!settings.scheme.solves_equations())
    return cost;
  // Rows that span the body's shorter side, unless a sparse factorisation takes over.
  const double n = cost.unknowns, band = 2. * per_edge * body.short_edge / h;
  cost.factor_seconds =
      std::min(fitted::factor_seconds * n * band * band, fitted::sparse_seconds * std::pow(n, 1.5));
  cost.condense_seconds = fitted::condense_seconds * std::pow(n, 1.5);
  cost.memory += 8. * n * std::min(band, 8. * std::log2(n + 2.));
  return cost;
}
} // namespace softgrain::mpm
