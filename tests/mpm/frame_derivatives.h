// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_mpm_frame_derivatives_h
#define softgrain_tests_mpm_frame_derivatives_h

// A frame of trial forces, and its derivatives against differences: in the plane and in space.
#include "scene_of.h"

#include <softgrain/mpm/contact/frame_state.h>

#include <cmath>
#include <iostream>
#include <random>

namespace softgrain::mpm
{
using Vectors = std::vector<Eigen::VectorXd>;

/// Adds vectors of nodes to those of a body.
template <int dim>
struct Into
{
  Eigen::VectorXd &nodal;
  void operator()(const unsigned int node, const dealii::Tensor<1, dim> &value) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      nodal[dim * node + d] += value[d];
  }
};

template <int dim>
class Contact
{
public:
  Contact(const FrameScene<dim> &scene, const Vectors &at_start, ContactFrame<dim> frame)
      : scene(scene), start(at_start), forces(frame.rays.size(), 0.7), frame(frame, scene)
  {
    for (unsigned int k = 0; k < forces.size(); ++k)
      forces[k] += 0.3 * k;
  }

  /// Whether all rays are met after the nodes have moved by @p way.
  bool go(const Vectors &way)
  {
    Vectors displacement = start;
    for (unsigned int b = 0; b < way.size(); ++b)
      displacement[b] += way[b];
    frame.prepare(scene, way, forces, 1., 1e9);
    frame.look(scene, displacement, way, {}, forces);
    return frame.meets(forces);
  }

  double gaps() const
  {
    double sum = 0.;
    for (unsigned int k = 0; k < forces.size(); ++k)
      sum += forces[k] * frame.ray(k).gap;
    return sum;
  }

  /// Force on the nodes of all bodies: the derivative of gaps().
  Vectors force() const
  {
    Vectors result(start.size());
    for (unsigned int b = 0; b < start.size(); ++b)
      result[b].setZero(start[b].size());
    for (unsigned int side = 0; side < 2; ++side)
      if (const unsigned int b = frame.body(side); b != FrameState<dim>::none)
      {
        for (unsigned int k = 0; k < forces.size(); ++k)
          frame.derivatives().for_gradient(k, side, forces[k], Into<dim>{result[b]});
        for (unsigned int m = 0; m < dim - 1; ++m)
          frame.derivatives().for_mean(side, m, -frame.derivatives().tangential(forces)[m],
                                       Into<dim>{result[b]});
      }
    return result;
  }

  /// Its change for a little way, by second derivatives.
  Vectors change(const Vectors &way) const
  {
    constexpr unsigned int n = dim - 1;
    std::array<Vectors, n> mixed, mean;
    Vectors result(start.size());
    std::array<double, n> moves{}, by_mixed{};
    for (unsigned int b = 0; b < start.size(); ++b)
      result[b].setZero(start[b].size());
    for (unsigned int m = 0; m < n; ++m)
      mixed[m] = mean[m] = result;
    for (unsigned int side = 0; side < 2; ++side)
      if (const unsigned int b = frame.body(side); b != FrameState<dim>::none)
      {
        for (unsigned int m = 0; m < n; ++m)
        {
          frame.derivatives().for_mixed(side, forces, frame.derivatives().as_motion(m),
                                        Into<dim>{mixed[m][b]});
          frame.derivatives().for_mean(side, m, 1., Into<dim>{mean[m][b]});
        }
        for (unsigned int k = 0; k < forces.size(); ++k)
          frame.ray(k).side[side].second_derivative(
              [&](const unsigned int i, const unsigned int j, const dealii::Tensor<2, dim> &block)
              {
                const double factor = (side == 0 ? -1. : 1.) * forces[k];
                for (unsigned int d = 0; d < dim; ++d)
                  for (unsigned int e = 0; e < dim; ++e)
                    result[b][dim * i + d] += factor * block[d][e] * way[b][dim * j + e];
              });
      }
    for (unsigned int b = 0; b < start.size(); ++b)
      for (unsigned int m = 0; m < n; ++m)
      {
        moves[m] += mean[m][b].dot(way[b]);
        by_mixed[m] += mixed[m][b].dot(way[b]);
      }
    for (unsigned int b = 0; b < start.size(); ++b)
      for (unsigned int m = 0; m < n; ++m)
      {
        double of_mean = by_mixed[m];
        for (unsigned int l = 0; l < n; ++l)
          of_mean += frame.derivatives().twice_by_motion(forces, m, l) * moves[l];
        result[b] += moves[m] * mixed[m][b] + of_mean * mean[m][b];
      }
    return result;
  }

  const FrameScene<dim> &scene;
  const Vectors start;
  std::vector<double> forces;
  FrameState<dim> frame;
};

inline double dot(const Vectors &a, const Vectors &b)
{
  double sum = 0.;
  for (unsigned int i = 0; i < a.size(); ++i)
    sum += a[i].dot(b[i]);
  return sum;
}

inline Vectors sum(const Vectors &a, const double factor, const Vectors &b)
{
  Vectors result = a;
  for (unsigned int i = 0; i < a.size(); ++i)
    result[i] += factor * b[i];
  return result;
}

/// Smooth changes of the nodes.
template <int dim>
Vectors changes(const std::vector<Body<dim>> &bodies, const unsigned int seed, const double size)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1., 1.);
  Vectors result;
  for (const Body<dim> &body : bodies)
  {
    Eigen::VectorXd of_body(body.field.n_dofs());
    double c[dim][dim + 2];
    for (auto &of_component : c)
      for (double &each : of_component)
        each = number(random);
    for (unsigned int i = 0; i < body.field.n_independent(); ++i)
    {
      const auto arm = body.field.place(i) - body.center();
      for (unsigned int d = 0; d < dim; ++d)
      {
        double value = c[d][0] + std::sin(c[d][dim + 1] * arm[d]);
        for (unsigned int e = 0; e < dim; ++e)
          value += c[d][1 + e] * arm[e];
        of_body[dim * i + d] = size * value;
      }
    }
    result.push_back(of_body);
  }
  return result;
}

template <int dim>
void look(const std::string &name, Contact<dim> contact, const std::vector<Body<dim>> &bodies)
{
  const Vectors here = changes(bodies, 5, 0.02), way = changes(bodies, 8, 1.);
  constexpr double little = 1e-5;
  const bool met = contact.go(here);
  const Vectors force = contact.force(), change = contact.change(way);
  dealii::Tensor<1, dim> net;
  for (const Eigen::VectorXd &of_body : force)
    for (unsigned int i = 0; i < of_body.size(); ++i)
      net[i % dim] += of_body[i];
  double across = net * contact.frame.layout().across[0];
  if constexpr (dim == 3)
    across = std::hypot(across, net * contact.frame.layout().across[1]);
  contact.go(sum(here, little, way));
  const double gaps_after = contact.gaps();
  const Vectors after = contact.force();
  contact.go(sum(here, -little, way));
  const double slope = (gaps_after - contact.gaps()) / (2. * little);
  const Vectors difference = sum(after, -1., contact.force());
  const double wrong_force = std::abs(dot(force, way) / slope - 1.);
  const double norm = std::sqrt(dot(change, change)),
               wrong_change = std::sqrt(dot(sum(change, -0.5 / little, difference),
                                            sum(change, -0.5 / little, difference))) /
                              std::max(norm, 1e-3);
  std::cout << name << ": rays " << contact.forces.size() << ", met " << met << ", force off by "
            << below(1e-7, wrong_force) << ", its change by " << below(1e-6, wrong_change)
            << ", net force along the frame " << below(1e-12, across) << ", has a second derivative "
            << (norm > 1e-3) << '\n';
}
} // namespace softgrain::mpm

#endif
