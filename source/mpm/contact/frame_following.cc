// SPDX-License-Identifier: LGPL-2.1-or-later
// Frames that follow narrow contacts in steps with inertia.
#include <softgrain/mpm/contact/frame_state.h>
#include <softgrain/mpm/contact/plane_compliance.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
constexpr double least_bend = 0.25; ///< of a contact that is followed, over that at the start

/// How much a gap bends over half a spacing to both sides; in space the product of both directions. None
/// where it does not bend upwards in all.
template <int n>
double bend_of(const dealii::Tensor<2, n> &change_of_slope, const double spacing)
{
  const double product = determinant(change_of_slope);
  return change_of_slope[0][0] > 0. && product > 0. ? product / std::pow(spacing, n) : 0.;
}

/// Force under which a contact of Hertz is as wide as rays are apart. @param bend as above
template <int dim>
double widest_narrow(const double bend, const double compliance, const double spacing)
{
  if (dim == 2)
    return M_PI * bend * 0.25 * spacing * spacing / (4. * compliance);
  const double radius = 0.5 * spacing;
  return 4. * std::sqrt(bend) * radius * radius * radius / (3. * compliance);
}
} // namespace

/// Finds the gaps half a spacing to all sides of a contact. @return whether there are any
template <int dim>
bool FrameState<dim>::meet_beside(const FrameScene<dim> &scene,
                                  const std::vector<Eigen::VectorXd> &displacement,
                                  const double wall_height)
{
  Across middle = at * moved;
  for (unsigned int k = 0; k < rays.size(); ++k)
    middle += weight[k] * frame.offset(frame.rays[k].index);
  const unsigned int strongest = std::max_element(weight.begin(), weight.end()) - weight.begin();
  for (unsigned int n = 0; n < beside.size(); ++n)
  {
    RayHere &here = beside[n];
    Across offset = middle;
    offset[n / 2] += (n % 2 == 0 ? -0.5 : 0.5) * frame.spacing;
    here.gap = 0.;
    here.by_motion = Across();
    for (unsigned int side = 0; side < 2; ++side)
    {
      const SurfacePlace<dim> &guess =
          here.side[side].met ? here.side[side].place : rays[strongest].side[side].place;
      if (!meet_side(scene, displacement, wall_height, side, offset, guess, here))
        return false;
    }
  }
  return true;
}

/// A contact of a round body that is narrower than its rays are apart, by Hertz's law a = √(4 F / π E* κ) or
/// in space a³ = 3 F / (4 E* κ), is followed.
template <int dim>
void FrameState<dim>::choose_followed(const FrameScene<dim> &scene,
                                      const std::vector<Eigen::VectorXd> &displacement,
                                      const double wall_height)
{
  bool round = false, all_met = true;
  double compliance = 0., pressed = 0.;
  for (const unsigned int b : {body(0), body(1)})
    if (b != none)
    {
      round = round || SubgridLaw<dim>::is_round(scene.bodies[b]);
      compliance += plane_compliance(scene.bodies[b]);
    }
  for (unsigned int k = 0; k < rays.size(); ++k)
  {
    pressed += std::max(0., frame.rays[k].force);
    all_met = all_met && (weight[k] == 0. || rays[k].met);
  }
  if (frame.corner != none || !round || !all_met || !meet_beside(scene, displacement, wall_height))
    return;
  bend_at_start = bend_of(change_of_slope(), frame.spacing);
  widest = widest_narrow<dim>(bend_at_start, compliance, frame.spacing);
  follows = pressed < widest;
  kept = difference_beside();
}

/// Moves the frame so that the gaps on all sides of it differ by what they did: on round surfaces it stays
/// as far from the least gap as it was. A contact that becomes wide is followed no more.
template <int dim>
void FrameState<dim>::follow(const FrameScene<dim> &scene,
                             const std::vector<Eigen::VectorXd> &displacement,
                             const std::vector<Eigen::VectorXd> &increment,
                             const double wall_height)
{
  const double h = scene.cell_size;
  for (unsigned int iteration = 0; iteration < 8; ++iteration)
  {
    if (sum_of_forces > widest || !meet_beside(scene, displacement, wall_height) ||
        !(bend_of(change_of_slope(), frame.spacing) > std::pow(least_bend, dim - 1) * bend_at_start))
    {
      follows = false;
      moved = mean_motion(increment);
      for (RayHere &ray : rays)
        for (PlaceFunctions<dim> &hold : ray.rub.hold)
          hold.node.clear(); // it holds what was in contact at the start
      return;
    }
    const Across way = invert(change_of_slope()) * (kept - difference_beside());
    if (way.norm() < 1e-10 * h)
      break;
    for (unsigned int m = 0; m < dim - 1; ++m)
      moved[m] += std::clamp(way[m], -0.5 * h, 0.5 * h) / at;
  }
  for (RayHere &here : beside)
    for (unsigned int side = 0; side < 2; ++side)
      if (unknown(side) != none)
        here.side[side].find_functions(scene.bodies[body(side)].field);
}

template void
FrameState<2>::choose_followed(const FrameScene<2> &, const std::vector<Eigen::VectorXd> &, double);
template void
FrameState<3>::choose_followed(const FrameScene<3> &, const std::vector<Eigen::VectorXd> &, double);
template void FrameState<2>::follow(const FrameScene<2> &,
                                    const std::vector<Eigen::VectorXd> &,
                                    const std::vector<Eigen::VectorXd> &,
                                    double);
template void FrameState<3>::follow(const FrameScene<3> &,
                                    const std::vector<Eigen::VectorXd> &,
                                    const std::vector<Eigen::VectorXd> &,
                                    double);
} // namespace softgrain::mpm
