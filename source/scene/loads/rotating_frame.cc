// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/parameters/parameter_values.h>
#include <softgrain/parameters/within_section.h>
#include <softgrain/scene/load.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <array>

namespace softgrain
{
namespace
{
/// What matter feels in a frame that turns steadily: centrifugal and Coriolis forces.
template <int dim>
class RotatingFrame final : public Load<dim>
{
public:
  std::string key() const override { return "Rotating frame/Angular velocity"; }

  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    using namespace dealii::Patterns;
    const std::string what = "Angular velocity of the frame in which places, velocities and walls are given: "
                             "all matter feels its centrifugal and its Coriolis force. ";
    prm.enter_subsection("Rotating frame");
    if (dim == 3)
      prm.declare_entry("Angular velocity", "0, 0, 0", List(Double(), 3, 3, ","),
                        what + "\"wx, wy, wz\". Units: rad/s.");
    else
      prm.declare_entry("Angular velocity", "0", Double(), what + "Counter-clockwise. Units: rad/s.");
    prm.declare_entry("Center", dim == 3 ? "0, 0, 0" : "0, 0", List(Double(), dim, dim, ","),
                      "A place on the axis of the frame. Units: m.");
    prm.leave_subsection();
  }

  void parse_parameters(dealii::ParameterHandler &prm) override
  {
    const WithinSection section(prm, "Rotating frame");
    dealii::Tensor<1, 3> omega; // along z in the plane
    if (dim == 3)
      omega = vector_of_numbers<3>(prm.get("Angular velocity"));
    else
      omega[2] = prm.get_double("Angular velocity");
    center = dealii::Point<dim>(vector_of_numbers<dim>(prm.get("Center")));
    // spin * r = omega x r, in the plane or in space.
    const double rows[3][3] = {
        {0., -omega[2], omega[1]}, {omega[2], 0., -omega[0]}, {-omega[1], omega[0], 0.}};
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e < dim; ++e)
        spin[d][e] = rows[d][e];
  }

  bool acts() const override { return spin.norm_square() > 0.; }
  bool sees_velocity() const override { return true; }

  dealii::Tensor<1, dim> acceleration(const LoadPlace<dim> &place) const override
  {
    return -1. * (spin * (spin * (place.now - center))) - 2. * (spin * place.velocity);
  }

  dealii::Tensor<2, dim> velocity_tangent(const LoadPlace<dim> &) const override { return -2. * spin; }

private:
  dealii::Tensor<2, dim> spin; ///< [1/s]
  dealii::Point<dim> center;   ///< [m]
};

[[maybe_unused]] const bool registered = add_load<RotatingFrame>("rotating_frame", "a frame that turns");
} // namespace
} // namespace softgrain
