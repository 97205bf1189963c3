// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_body_point_view_h
#define softgrain_mpm_body_point_view_h

#include <softgrain/mpm/body/point_layout.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <deal.II/particles/property_pool.h>

namespace softgrain::mpm
{
/**
 * @brief One material point to be read: references into the property pool of the particles, slot by slot.
 *
 * What is read through it is the state itself, nothing is copied. A view, and every reference it gave, is
 * void as soon as points are added or sorted.
 */
template <int dim>
class PointView
{
public:
  using Pool = dealii::Particles::PropertyPool<dim>;
  using Handle = typename Pool::Handle;

  PointView(Pool &pool, const PointLayout<dim> &layout, const Handle handle)
      : pool(&pool), handle(handle), properties(pool.get_properties(handle).data()), layout(&layout)
  {
  }

  /// Place when the grid was laid [m].
  const dealii::Point<dim> &position() const { return pool->get_location(handle); }
  unsigned int body() const { return static_cast<unsigned int>(at<double>(PointSlot::body)); }
  double rest_volume() const { return at<double>(PointSlot::rest_volume); }
  double mass() const { return at<double>(PointSlot::mass); }
  double half_extent() const { return at<double>(PointSlot::half_extent); }
  const dealii::Tensor<2, dim> &gradient() const { return at<dealii::Tensor<2, dim>>(PointSlot::gradient); }
  const dealii::Tensor<1, dim> &velocity() const { return at<dealii::Tensor<1, dim>>(PointSlot::velocity); }
  const dealii::SymmetricTensor<2, dim> &stress() const
  {
    return at<dealii::SymmetricTensor<2, dim>>(PointSlot::stress);
  }
  /// Volume; it is there only where the layout has it, like those that follow.
  double volume() const { return at<double>(PointSlot::volume); }
  const dealii::Tensor<2, dim> &affine() const { return at<dealii::Tensor<2, dim>>(PointSlot::affine); }
  const double *history() const { return &at<double>(PointSlot::history); }

  /// First double of any slot.
  const double *data(const PointSlot slot) const { return &at<double>(slot); }

protected:
  /// Tensors are arrays of doubles and nothing else, as are the properties of a particle.
  template <typename T>
  T &at(const PointSlot slot) const
  {
    static_assert(sizeof(T) % sizeof(double) == 0 && alignof(T) == alignof(double), "not a pack of doubles");
    Assert(layout->has(slot),
           dealii::ExcMessage("The points of this scene do not carry what was asked for."));
    return *reinterpret_cast<T *>(properties + layout->offset(slot));
  }

  Pool *pool;
  Handle handle;

private:
  double *properties;
  const PointLayout<dim> *layout;
};
} // namespace softgrain::mpm

#endif
