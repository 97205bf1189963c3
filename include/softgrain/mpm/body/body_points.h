// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_body_body_points_h
#define softgrain_mpm_body_body_points_h

#include <softgrain/mpm/body/point_layout.h>
#include <softgrain/mpm/body/writable_point.h>

#include <utility>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief The material points of one body in the order in which its field counts them: by cell, in a cell by
 * id.
 *
 * The points themselves live in the PointStore; this is the list of their handles.
 */
template <int dim>
class BodyPoints
{
public:
  using Handle = typename PointView<dim>::Handle;

  BodyPoints() = default;
  /// @param first_id id of the first point of the body; the ids of a body follow one another
  BodyPoints(typename PointView<dim>::Pool &pool, const PointLayout<dim> &layout, const unsigned int first_id)
      : pool(&pool), the_layout(&layout), first_id(first_id)
  {
  }

  std::size_t size() const { return handles.size(); }
  const PointLayout<dim> &layout() const { return *the_layout; }

  WritablePoint<dim> operator[](const std::size_t p) { return {*pool, *the_layout, handles[p]}; }
  PointView<dim> operator[](const std::size_t p) const { return {*pool, *the_layout, handles[p]}; }

  /// Number of point @p p in the body, in the order of generation.
  unsigned int number(const std::size_t p) const { return pool->get_id(handles[p]) - first_id; }

  /// Takes the handles of its points, which every sort changes, and where they are.
  void renew(typename PointView<dim>::Pool &new_pool, std::vector<Handle> new_handles)
  {
    pool = &new_pool;
    handles = std::move(new_handles);
  }

private:
  typename PointView<dim>::Pool *pool = nullptr;
  const PointLayout<dim> *the_layout = nullptr;
  unsigned int first_id = 0;
  std::vector<Handle> handles;
};
} // namespace softgrain::mpm

#endif
