// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/expression.h>
#include <softgrain/parameters/within_section.h>
#include <softgrain/scene/load.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/thread_local_storage.h>

#include <cmath>
#include <memory>
#include <vector>

namespace softgrain
{
namespace
{
/// A medium that takes matter along: what goes with it feels nothing.
template <int dim>
class Drag final : public Load<dim>
{
public:
  std::string key() const override { return "Drag/Rate"; }

  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    using namespace dealii::Patterns;
    prm.enter_subsection("Drag");
    prm.declare_entry(
        "Rate", "0", Double(0),
        "Linear drag: force per mass over the velocity beside that of the medium; 0: none. In a "
        "medium at rest velocities fall to a third (1/e) in 1/Rate. Units: 1/s.");
    prm.declare_entry("Velocity", dim == 3 ? "0; 0; 0" : "0; 0", Anything(),
                      std::string("Velocity of the medium, formulas (doc/formulas.md) of ") +
                          (dim == 3 ? "x, y, z and t: \"vx; vy; vz\"" : "x, y and t: \"vx; vy\"") +
                          ". Units: m/s.");
    prm.leave_subsection();
  }

  void parse_parameters(dealii::ParameterHandler &prm) override
  {
    const WithinSection section(prm, "Drag");
    rate = prm.get_double("Rate");
    const std::string text = prm.get("Velocity"), path = "'Loads/Drag/Velocity' = '" + text + "'";
    std::vector<Expression> formulas;
    try
    {
      formulas = dim == 3 ? vector_expression(text, {"x", "y", "z", "t"}, 3)
                          : vector_expression(text, {"x", "y", "t"});
    }
    catch (const InputError &error)
    {
      throw InputError("'Loads/Drag/Velocity': " + std::string(error.what()));
    }
    for (const Expression &component : formulas)
      if (!std::isfinite(component(std::vector<double>(dim + 1, 0.))))
        throw InputError(path + " is not finite at the origin at t = 0");
    if (rate == 0. && text != (dim == 3 ? "0; 0; 0" : "0; 0"))
      throw InputError(path + " has no effect with 'Loads/Drag/Rate' = '0': leave it out, or set the rate "
                              "greater than 0");
    medium = std::make_unique<OfThreads>(std::move(formulas));
  }

  bool acts() const override { return rate > 0.; }
  bool sees_velocity() const override { return true; }

  dealii::Tensor<1, dim> acceleration(const LoadPlace<dim> &place) const override
  {
    std::vector<double> at(place.now.begin_raw(), place.now.end_raw());
    at.push_back(place.time);
    const std::vector<Expression> &flow = medium->get();
    dealii::Tensor<1, dim> beside = place.velocity;
    for (unsigned int d = 0; d < dim; ++d)
      beside[d] -= flow[d](at);
    return -rate * beside;
  }

  dealii::Tensor<2, dim> velocity_tangent(const LoadPlace<dim> &) const override
  {
    dealii::Tensor<2, dim> tangent;
    for (unsigned int d = 0; d < dim; ++d)
      tangent[d][d] = -rate;
    return tangent;
  }

private:
  double rate = 0.; ///< [1/s]
  /// Formulas keep the values of their variables, so every thread has its own.
  using OfThreads = dealii::Threads::ThreadLocalStorage<std::vector<Expression>>;
  std::unique_ptr<OfThreads> medium;
};

[[maybe_unused]] const bool registered = add_load<Drag>("drag", "a medium that takes matter along");
} // namespace
} // namespace softgrain
