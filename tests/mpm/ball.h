// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_mpm_ball_h
#define softgrain_tests_mpm_ball_h

#include <softgrain/constitutive/law_registry.h>
#include <softgrain/mpm/body/solid_builder.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

/// A ball with Young's modulus 1 that a grid cuts, with all that it stands on.
struct Ball
{
  using Values = std::vector<std::pair<std::string, std::string>>;

  /// @param cut shift of the ball on the grid @param more values of parameters of the law
  Ball(const double radius,
       const double cell,
       const std::string &law,
       const double poisson_ratio = 0.3,
       const double cut = 0.,
       const Values &more = {})
      : lattice(dealii::Point<3>(), dealii::Point<3>(8., 8., 8.), cell)
      , shape(softgrain::mpm::create_shape_function("bspline"))
      , sphere(dealii::Point<3>(4.13 + cut, 3.91 + 0.7 * cut, 4.07 + cut), radius)
      , law(law_of(law, poisson_ratio, more))
      , store(lattice, softgrain::mpm::PointLayout<3>(needs()))
  {
    using namespace softgrain;
    store.cover_all();
    const std::vector<dealii::Point<3>> markers = sphere.surface(0.7 * cell).vertices;
    body = mpm::make_solid("ball", sphere, this->law, 1., mpm::Settings(), *shape, lattice, markers, store);
  }

  static std::shared_ptr<const softgrain::constitutive::Law<3>>
  law_of(const std::string &law, const double poisson_ratio, const Values &more)
  {
    using namespace softgrain;
    dealii::ParameterHandler prm;
    constitutive::declare_all_laws(prm);
    prm.enter_subsection(constitutive::law_title(law));
    prm.set("Young's modulus", 1.);
    prm.set("Poisson's ratio", poisson_ratio);
    for (const auto &[name, value] : more)
      prm.set(name, value);
    prm.leave_subsection();
    return constitutive::create_law<3>(law, prm);
  }

  softgrain::mpm::PointNeeds needs() const
  {
    softgrain::mpm::PointNeeds needs;
    needs.velocity = false;
    needs.n_history = law->n_history();
    return needs;
  }

  softgrain::mpm::Lattice<3> lattice;
  std::unique_ptr<softgrain::mpm::ShapeFunction> shape;
  softgrain::Sphere sphere;
  std::shared_ptr<const softgrain::constitutive::Law<3>> law;
  softgrain::mpm::PointStore<3> store;
  softgrain::mpm::Body<3> body;
};

#endif
