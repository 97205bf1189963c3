// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_body_writable_point_h
#define softgrain_mpm_body_writable_point_h

#include <softgrain/mpm/body/point_view.h>

namespace softgrain::mpm
{
/// One material point to be written, too.
template <int dim>
class WritablePoint : public PointView<dim>
{
public:
  using PointView<dim>::PointView;
  using PointView<dim>::rest_volume;
  using PointView<dim>::mass;
  using PointView<dim>::half_extent;
  using PointView<dim>::gradient;
  using PointView<dim>::velocity;
  using PointView<dim>::stress;
  using PointView<dim>::volume;
  using PointView<dim>::affine;
  using PointView<dim>::history;
  using PointView<dim>::data;

  void move_to(const dealii::Point<dim> &x) { this->pool->set_location(this->handle, x); }

  double &rest_volume() { return this->template at<double>(PointSlot::rest_volume); }
  double &mass() { return this->template at<double>(PointSlot::mass); }
  double &half_extent() { return this->template at<double>(PointSlot::half_extent); }
  dealii::Tensor<2, dim> &gradient()
  {
    return this->template at<dealii::Tensor<2, dim>>(PointSlot::gradient);
  }
  dealii::Tensor<1, dim> &velocity()
  {
    return this->template at<dealii::Tensor<1, dim>>(PointSlot::velocity);
  }
  dealii::SymmetricTensor<2, dim> &stress()
  {
    return this->template at<dealii::SymmetricTensor<2, dim>>(PointSlot::stress);
  }
  double &volume() { return this->template at<double>(PointSlot::volume); }
  dealii::Tensor<2, dim> &affine() { return this->template at<dealii::Tensor<2, dim>>(PointSlot::affine); }
  double *history() { return &this->template at<double>(PointSlot::history); }
  double *data(const PointSlot slot) { return &this->template at<double>(slot); }
};
} // namespace softgrain::mpm

#endif
