// SPDX-License-Identifier: LGPL-2.1-or-later
// A nearly incompressible disk between plates: the deformation that a snapshot shows is that of which the law
// makes the stress, also with F-bar, where the points of a cell have their own dilatations: the law gives
// back the stress that the snapshot shows. Area times stress is the force of a point, whichever dilatation
// counts.
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
using Tensor = dealii::Tensor<2, 2>;

/// F of the points as their own places move, in the order of the snapshot.
std::vector<Tensor> own_gradients(const mpm::Body<2> &body)
{
  std::vector<Tensor> result(body.n_points);
  Eigen::VectorXd u;
  body.field.extension().prolongate(body.nodes.displacement, u);
  for (unsigned int p = 0; p < body.points.size(); ++p)
  {
    Tensor gradient({{1., 0.}, {0., 1.}});
    for (unsigned int k = 0; k < body.field.cells().nodes_per_cell(); ++k)
    {
      const unsigned int i = body.field.at_point(p).nodes[k];
      gradient +=
          outer_product(dealii::Tensor<1, 2>({u[2 * i], u[2 * i + 1]}), body.field.at_point(p).slopes[k]);
    }
    result[body.points.number(p)] = gradient * Tensor(body.points[p].gradient());
  }
  return result;
}

/// The largest difference between the mean of both stresses that neo-Hooke's law makes of @p F and the one
/// shown, over the largest one shown.
double misfit(const PointStates<2> &points, const std::vector<Tensor> &F, const double E, const double nu)
{
  const double mu = E / 2 / (1 + nu), lambda = E * nu / (1 + nu) / (1 - 2 * nu);
  double worst = 0., largest = 0.;
  for (unsigned int p = 0; p < F.size(); ++p)
  {
    const double J = determinant(F[p]);
    const double mean = (mu * (F[p].norm_square() / 2 - 1) + lambda * std::log(J)) / J;
    worst = std::max(worst, std::abs(mean - trace(points.stress[p]) / 2));
    largest = std::max(largest, std::abs(trace(points.stress[p]) / 2));
  }
  return worst / largest;
}

/// Root of the mean square of what is left of the volume strain when the part that the stress shows, its mean
/// over the bulk modulus, is taken away.
double mottle(const PointStates<2> &points, const std::vector<Tensor> &F, const double E, const double nu)
{
  const double lambda = E * nu / (1 + nu) / (1 - 2 * nu), bulk = lambda + E / 2 / (1 + nu);
  double sum = 0.;
  for (unsigned int p = 0; p < F.size(); ++p)
    sum += std::pow(std::log(determinant(F[p])) - trace(points.stress[p]) / 2 / bulk, 2);
  return std::sqrt(sum / F.size());
}

void finite_strain(const std::string &f_bar)
{
  const auto model = shipped_scene("verification/line_contact.prm",
                                   {"Materials/gel/Neo-Hookean/Poisson's ratio=0.49", "Mesh/Cell size=1e-3",
                                    "Time/Time step=0.05", "Material points/F-bar=" + f_bar});
  run_until(*model, 0.3);
  const Snapshot<2> seen = model->snapshot();
  const std::vector<Tensor> own = own_gradients(model->bodies()[0]);
  const double E = 10e6, nu = 0.49;
  dealii::SymmetricTensor<2, 2> forces;
  for (unsigned int p = 0; p < own.size(); ++p)
    forces += seen.points.size[p] * seen.points.stress[p];
  const BodyState<2> &disk = seen.bodies[0];
  std::cout << "F-bar " << f_bar << ": stress of the law from F shown "
            << below(1e-12, misfit(seen.points, seen.points.deformation_gradient, E, nu))
            << " of the largest, from F of the places " << below(1e-12, misfit(seen.points, own, E, nu))
            << "; mottle of ln J shown " << mottle(seen.points, seen.points.deformation_gradient, E, nu)
            << ", of the places " << mottle(seen.points, own, E, nu)
            << "; stress times area over that of the body "
            << below(1e-12,
                     (forces - disk.area * disk.mean_stress).norm() / (disk.area * disk.mean_stress.norm()))
            << '\n';
}
/// Laws of small strain add up averaged strains: their stress is that of the F shown up to second order.
void small_strain()
{
  const double E = 10e6, nu = 0.49;
  const auto model =
      shipped_scene("verification/line_contact.prm",
                    {"Materials/gel/Law=linear_elastic", "Materials/gel/Linear elastic/Young's modulus=1e7",
                     "Materials/gel/Linear elastic/Poisson's ratio=0.49", "Mesh/Cell size=1e-3",
                     "Time/Time step=1e-3", "Material points/F-bar=on"});
  run_until(*model, 2e-3);
  const PointStates<2> seen = model->snapshot().points;
  std::cout << "small strain: misfit of F shown "
            << below(0.02, misfit(seen, seen.deformation_gradient, E, nu)) << ", of the places "
            << misfit(seen, own_gradients(model->bodies()[0]), E, nu) << '\n';
}
} // namespace

int main()
{
  finite_strain("off");
  finite_strain("on");
  small_strain();
}
